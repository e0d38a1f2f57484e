#include "lib/run/moos_text/node_message_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <vector>

namespace shoal::node_message_text_test {

MoosNodeMessage Parsed(std::string_view text) {
  auto message = ParseNodeMessage(text);
  EXPECT_TRUE(message.ok()) << (message.ok() ? "" : message.error());
  return message.ok() ? *message : MoosNodeMessage();
}

std::string ErrorOf(std::string_view text) {
  const auto message = ParseNodeMessage(text);
  return message.ok() ? "" : message.error();
}

TEST(ParseNodeMessage, ReadsEveryField) {
  EXPECT_EQ(Parsed("src_node=alpha,src_app=pX,dest_node=bravo:charlie,dest_group=red,var_name=FOO,"
                   "string_val=\"speed=2, now\",color=green,ack=TRUE,ack_id=alpha_1,src_bhv=b"),
            (MoosNodeMessage{.src_node = "alpha",
                             .src_app = "pX",
                             .dest_node = "bravo:charlie",
                             .dest_group = "red",
                             .var_name = "FOO",
                             .string_val = "speed=2, now",
                             .double_val = std::nullopt,
                             .color = "green",
                             .ack = true,
                             .ack_id = "alpha_1",
                             .extra = {{"src_bhv", "b"}}}));
}

TEST(ParseNodeMessage, TakesDestNameForDestNode) {
  EXPECT_EQ(Parsed("src_node=a,dest_name=bravo,var_name=F,double_val=1.5").dest_node, "bravo");
  EXPECT_EQ(ErrorOf("src_node=a,dest_name=b,dest_node=b,var_name=F"),
            "dest_node is given twice; leave one of the two");
}

TEST(ParseNodeMessage, KeepsANumberApartFromAText) {
  EXPECT_EQ(Parsed("src_node=a,dest_node=b,var_name=F,double_val=-0.5").double_val, -0.5);
  EXPECT_EQ(Parsed("src_node=a,dest_node=b,var_name=F,string_val=1").double_val, std::nullopt);
  EXPECT_EQ(Parsed("src_node=a,dest_node=b,var_name=F").string_val, "");
}

TEST(ParseNodeMessage, ReportsWhatIsMissingOrWrong) {
  EXPECT_EQ(ErrorOf(""), "src_node is missing; write src_node=<vehicle>");
  EXPECT_EQ(ErrorOf("src_node=a,var_name=F"),
            "dest_node and dest_group are missing; write dest_node=<vehicle> or all");
  EXPECT_EQ(ErrorOf("src_node=a,dest_node=b"), "var_name is missing; write var_name=<variable>");
  EXPECT_EQ(ErrorOf("src_node=a,dest_node=b,var_name=F,double_val=x"),
            "double_val = 'x' is not a finite number; write string_val=... for text");
  EXPECT_EQ(ErrorOf("src_node=a,dest_node=b,var_name=F,double_val=1,string_val=x"),
            "string_val and double_val are both given; leave one of the two");
  EXPECT_EQ(ErrorOf("src_node=a,dest_node=b,var_name=F,ack=yes"),
            "ack = 'yes' is neither true nor false");
  EXPECT_NE(ErrorOf("src_node=a,dest_node=b,var_name=F,string_val=hello, world")
                .find("holds a comma in double quotes"),
            std::string::npos);
}

RC_GTEST_PROP(ParseNodeMessage, GivesBackAnyTextThatAppendFieldWrote, (const std::string& value)) {
  std::string text = "src_node=a,dest_node=b,var_name=F";
  AppendField("string_val", value, &text);
  Result<MoosNodeMessage> message = ParseNodeMessage(text);
  RC_ASSERT(message.ok());
  RC_ASSERT(message->string_val == value);
}

}  // namespace shoal::node_message_text_test
