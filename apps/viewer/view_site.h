// The addresses of the viewer: docs/extending/viewer_protocol.md. Answers the requests of
// WebServer from a ViewSource; knows nothing of sockets.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "apps/viewer/access.h"
#include "apps/viewer/channel_source.h"
#include "apps/viewer/page_files.h"
#include "apps/viewer/plan_desk.h"
#include "apps/viewer/view_request.h"
#include "apps/viewer/web_server.h"
#include "lib/tools/view/view_source.h"

namespace shoal {

/// The functions may be called from any thread. Those that need a running mission are absent where
/// the viewer shows a log.
struct ViewSiteParts {
  PageFiles files = {};
  AccessRules access = {};
  bool is_live = false;
  std::function<std::shared_ptr<ViewSource>()> source = {};          ///< The current one.
  std::function<std::shared_ptr<ChannelSource>()> channels = {};     ///< The current one.
  std::function<std::string()> status = {};                          ///< Answers /api/status.
  std::function<WebAnswer(const CommandWords& words)> command = {};  ///< Carries out an order.
  std::shared_ptr<PlanDesk> plan = {};  ///< Of edits of the mission file.
  std::string outside_tiles = {};       ///< The URL of tiles that the page may load; empty: none.
};

class ViewSite : public WebSite {
 public:
  explicit ViewSite(ViewSiteParts parts) : parts_(std::move(parts)) {}

  std::optional<WebAnswer> Deny(const WebRequest& request) override;
  WebAnswer Reply(const WebRequest& request) override;

 private:
  WebAnswer ReplyWithData(const WebRequest& request);
  WebAnswer OutsideJson() const;
  WebAnswer ReplyOfChannels(const WebRequest& request);

  const ViewSiteParts parts_;
};

}  // namespace shoal
