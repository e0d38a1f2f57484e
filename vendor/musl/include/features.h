/* The headers of musl's tables include <features.h>; libm.h does, too. */
#include_next <features.h>
/* log, log2 and pow have other sums for processors that fuse products: never here. */
#undef __FP_FAST_FMA
#ifndef hidden
#define hidden
#define __exp_data shoal_exp_data
#define __log_data shoal_log_data
#define __log2_data shoal_log2_data
#define __pow_log_data shoal_pow_log_data
#endif
