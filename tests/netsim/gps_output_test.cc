#include "lib/mission/netsim/gps_output.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/netsim/tcp_client.h"

namespace shoal::gps_output_test {

namespace fs = std::filesystem;

const std::string kSentence = "$GPRMC,1*2E\r\n";

/// A folder that goes with the test.
class GpsOutputTest : public testing::Test {
 protected:
  GpsOutputTest() {
    std::string pattern = (fs::temp_directory_path() / "gps_output_XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~GpsOutputTest() override { fs::remove_all(folder_); }

  static std::unique_ptr<GpsOutput> Open(const NetsimGps& gps) {
    auto output = GpsOutput::Open(gps, "127.0.0.1");
    EXPECT_TRUE(output.ok()) << (output.ok() ? "" : output.error());
    return output.ok() ? std::move(*output) : nullptr;
  }

  fs::path folder_;
};

TEST_F(GpsOutputTest, AppendsToAFile) {
  const std::string path = folder_ / "gps.txt";
  for (int i = 0; i < 2; ++i) Open({.path = path})->Write(kSentence);
  std::ifstream in(path, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), kSentence + kSentence);
}

TEST_F(GpsOutputTest, WritesToAPseudoTerminalAsItIs) {
  const FileDescriptor master(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK));
  if (!master.is_open()) GTEST_SKIP() << "this machine cannot make a pseudo-terminal (/dev/pts)";
  ASSERT_EQ(grantpt(master.get()), 0);
  ASSERT_EQ(unlockpt(master.get()), 0);
  const auto output = Open({.path = ptsname(master.get())});
  ASSERT_NE(output, nullptr);
  output->Write(kSentence);
  pollfd waited{.fd = master.get(), .events = POLLIN, .revents = 0};
  EXPECT_EQ(poll(&waited, 1, 1000), 1);
  char text[100];
  const ssize_t size = read(master.get(), text, sizeof text);
  EXPECT_EQ(std::string(text, text + std::max<ssize_t>(size, 0)), kSentence);
}

TEST_F(GpsOutputTest, CountsWhatIsNeverRead) {
  const std::string path = folder_ / "pipe";
  ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
  const auto output = Open({.path = path});
  ASSERT_NE(output, nullptr);
  for (int i = 0; i < 100'000 && output->num_lost() == 0; ++i) output->Write(kSentence);
  EXPECT_GT(output->num_lost(), 0);
}

TEST_F(GpsOutputTest, NamesAClientTooMany) {
  const int port = (*TcpServer::Listen({}, {}))->port();
  std::vector<std::string> refused;
  const auto output =
      GpsOutput::Open({.tcp_port = port}, "127.0.0.1",
                      [&](const std::string& address) { refused.push_back(address); });
  ASSERT_TRUE(output.ok()) << output.error();
  std::vector<std::unique_ptr<TcpClient>> clients;
  for (int i = 0; i < GpsOutput::kMaxClients + 1; ++i) {
    clients.push_back(std::make_unique<TcpClient>(port));
  }
  for (int turn = 0; turn < 100 && refused.empty(); ++turn) {
    (*output)->Serve(0);
    pollfd waited{.fd = (*output)->fd(), .events = POLLIN, .revents = 0};
    poll(&waited, 1, 10);
  }
  EXPECT_EQ(refused, std::vector<std::string>{"127.0.0.1"});
  EXPECT_EQ((*output)->counts().refused, 1);
}

TEST_F(GpsOutputTest, WritesToAllClientsThatConnect) {
  // A port that was free a moment ago.
  const int port = (*TcpServer::Listen({}, {}))->port();
  const auto output = Open({.tcp_port = port});
  ASSERT_NE(output, nullptr);
  TcpClient clients[] = {TcpClient(port), TcpClient(port)};
  output->Serve(0);
  output->Write(kSentence);
  for (TcpClient& client : clients) {
    pollfd waited{.fd = client.fd(), .events = POLLIN, .revents = 0};
    EXPECT_EQ(poll(&waited, 1, 1000), 1);
    client.Receive();
    EXPECT_EQ(client.received(), kSentence);
  }
}

TEST_F(GpsOutputTest, WritesNowhereByDefault) {
  const auto output = Open({});
  ASSERT_NE(output, nullptr);
  output->Write(kSentence);
  output->Serve(0);
  EXPECT_LT(output->fd(), 0);
  EXPECT_EQ(output->num_lost(), 0);
}

TEST_F(GpsOutputTest, NamesWhatItCannotOpen) {
  const auto missing = GpsOutput::Open({.path = folder_ / "no" / "gps.txt"}, "127.0.0.1");
  ASSERT_FALSE(missing.ok());
  EXPECT_NE(missing.error().find("no/gps.txt: cannot be written: No such file"), std::string::npos);
  const auto server = TcpServer::Listen({}, {});
  ASSERT_TRUE(server.ok());
  EXPECT_FALSE(GpsOutput::Open({.tcp_port = (*server)->port()}, "127.0.0.1").ok());
}

}  // namespace shoal::gps_output_test
