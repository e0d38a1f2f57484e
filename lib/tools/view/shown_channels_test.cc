// Every row of shown_channels.h reaches a frame, and its key and its channel stand where they must.
#include "lib/tools/view/shown_channels.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "lib/tools/view/frame_json.h"
#include "lib/tools/view/view_testing.h"

namespace shoal::shown_channels_test {

TEST(ShownChannels, AreChannelsOfAVehicleOrNameOneAndTheViewerSubscribesToThem) {
  ForEachShownChannel([]<class Row, size_t kRow>() {
    constexpr bool kIsOfAll = requires(const typename Row::Message& m) { Row::VehicleOf(m); };
    const std::string channel = Row::ChannelOf("alpha").name;
    bool is_found = false;
    for (const ChannelRow& row : ChannelTable()) {
      if (kIsOfAll ? row.topic != channel : VehicleOfChannel(channel, row.topic) != "ALPHA")
        continue;
      if ((row.home == ChannelHome::kVehicle) == kIsOfAll) continue;
      is_found = true;
      EXPECT_EQ(row.type, Row::Message::getTypeName()) << channel;
      EXPECT_NE(row.subscribers.find("viewer"), std::string_view::npos)
          << "lib/bus/bus/channels.cc does not name the viewer among the subscribers of "
          << row.topic;
    }
    EXPECT_TRUE(is_found) << channel;
  });
}

TEST(ShownChannels, AreNullInAFrameUntilAMessageArrivesAndThenAnObject) {
  Scene scene(MissionOf({"alpha"}));
  const auto vehicle = [&] {
    return nlohmann::json::parse(FrameJson(scene, WholeFrame(scene)))["vehicles"][0];
  };
  ForEachShownChannel([&]<class Row, size_t kRow>() {
    const std::string key(Row::kKey);
    ASSERT_TRUE(vehicle().contains(key));
    EXPECT_TRUE(vehicle()[key].is_null()) << key;
    typename Row::Message message{};
    if constexpr (requires { message.receiver; }) message.receiver = "ALPHA";
    scene.Handle(Row::ChannelOf("alpha").name, Encoded(message));
    EXPECT_TRUE(vehicle()[key].is_object()) << key;
  });
}

TEST(ShownChannels, HaveKeysOfTheirOwnWhichThePageOfTheProtocolHas) {
  std::ifstream file(std::string(SHOAL_SOURCE_DIR) + "/docs/extending/viewer_protocol.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  std::set<std::string_view> keys = {"nav", "report", "helm", "stale", "mode", "outside"};
  ForEachShownChannel([&]<class Row, size_t kRow>() {
    EXPECT_TRUE(keys.insert(Row::kKey).second) << Row::kKey;
    EXPECT_NE(page.find("\"" + std::string(Row::kKey) + "\": {"), std::string::npos)
        << "docs/extending/viewer_protocol.md does not have " << Row::kKey;
  });
}

}  // namespace shoal::shown_channels_test
