/* Prints the node reports of a running mission: a listener in plain C that takes no part in
 * stepping and needs nothing but LCM and the message types.
 *
 *   c_listener "$(build/bin/shoal url)"                          what the vehicles publish
 *   c_listener "$(build/bin/shoal url bravo)" NODE_REPORT_BRAVO  what bravo receives of the others
 */
#include <lcm/lcm.h>
#include <stdio.h>
#include <stdlib.h>

#include "shoal_node_report_t.h"

static void on_report(const lcm_recv_buf_t* datagram, const char* channel,
                      const shoal_node_report_t* report, void* unused) {
  (void)datagram, (void)unused;
  printf("%9.1f s  %-20s %-10s x %8.1f m  y %8.1f m  %4.1f m/s  %5.1f deg  %s\n",
         (double)report->utime / 1e6, channel, report->name, report->x_m, report->y_m,
         report->speed_mps, report->heading_deg, report->mode);
}

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    fprintf(stderr,
            "usage: c_listener LCM_URL [CHANNEL], for example\n"
            "  c_listener \"$(build/bin/shoal url)\" NODE_REPORT_LOCAL\n");
    return 2;
  }
  setvbuf(stdout, NULL, _IOLBF, 0);
  lcm_t* lcm = lcm_create(argv[1]);
  if (lcm == NULL) {
    fprintf(stderr, "c_listener: cannot open %s; `shoal doctor` shows why\n", argv[1]);
    return 3;
  }
  const char* channel = argc == 3 ? argv[2] : "NODE_REPORT_LOCAL";
  shoal_node_report_t_subscription_t* subscription =
      shoal_node_report_t_subscribe(lcm, channel, on_report, NULL);
  /* LCM keeps 30 messages by default and drops what comes on top; a step may bring more. */
  shoal_node_report_t_subscription_set_queue_capacity(subscription, 0);
  while (lcm_handle(lcm) == 0) continue;
  lcm_destroy(lcm);
  return 3;
}
