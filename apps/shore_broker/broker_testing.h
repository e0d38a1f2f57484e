// A broker and two vehicles, bravo and alpha, for which tests publish.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/shore_broker/shore_broker_app.h"
#include "lib/bus/bus/control_message.h"
#include "lib/bus/bus/memory_bus.h"

namespace shoal {

inline constexpr int64_t kStep_us = 100'000;
inline constexpr int64_t kStart_utime = 50'000'000;

/// comms_range = 250, no critical range.
inline Mission TwoVehicles() {
  Mission mission;
  mission.vehicles.resize(2);
  mission.vehicles[0].name = "alpha";
  mission.vehicles[1].name = "bravo";
  mission.vehicles[0].acoustic_address = 1;
  mission.vehicles[1].acoustic_address = 2;
  mission.comms.comms_range_m = 250;
  mission.comms.critical_range_m = 0;
  mission.start_utime = kStart_utime;
  return mission;
}

inline node_report_t ReportFrom(const std::string& name, double x_m, double y_m = 0) {
  node_report_t report = {};
  report.name = name;
  report.x_m = x_m;
  report.y_m = y_m;
  report.num_extra = 1;
  report.extra = {{.key = "payload", .value = "ctd"}};
  return report;
}

inline node_message_t MessageFrom(const std::string& src_node, const std::string& dest_node) {
  node_message_t message = {};
  message.src_node = src_node;
  message.dest_node = dest_node;
  message.var_name = "FOOBAR";
  message.string_val = "hello";
  return message;
}

class BrokerFixture : public testing::Test {
 protected:
  explicit BrokerFixture(const Mission& mission = TwoVehicles()) : mission_(mission) {
    for (const std::string name : {"alpha", "bravo", "charlie"}) {
      Keep(channels::NodeReport(name).name, &received_[name]);
      Keep(channels::NodeMessage(name).name, &messages_[name]);
      Keep(channels::AckMessageTo(name).name, &acks_[name]);
      Subscribe(listener_, channels::AcousticRx(name),
                [this, name](const acoustic_rx_t& packet) { packets_[name].push_back(packet); });
      Subscribe(listener_, channels::HelmCommand(name),
                [this, name](const helm_command_t& command) { orders_[name] = command.command; });
    }
    Subscribe(listener_, channels::CommsFates(), [this](const comms_fates_t& message) {
      fates_.insert(fates_.end(), message.fates.begin(), message.fates.end());
    });
    Subscribe(listener_, channels::ViewCommsPulse(), [this](const comms_pulses_t& message) {
      pulses_.insert(pulses_.end(), message.pulses.begin(), message.pulses.end());
    });
    Subscribe(listener_, channels::CommsRules(),
              [this](const broker_rules_t& rules) { rules_.push_back(FromMessage(rules)); });
    Subscribe(listener_, channels::NodeReportUnc(),
              [this](const node_report_t& report) { shared_.push_back(report.name); });
    Subscribe(listener_, channels::UncControlsReq(),
              [this](const unc_controls_req_t&) { ++num_requests_; });
  }

  void Send(const node_report_t& report) {
    Publish(listener_, channels::NodeReportLocal(), report);
  }
  void Send(const node_message_t& message) {
    Publish(listener_, channels::NodeMessageLocal(), message);
  }
  void Send(const ack_message_t& ack) { Publish(listener_, channels::AckMessage(), ack); }
  void SendPacket(const std::string& source, const Bytes& payload) {
    acoustic_tx_t packet = {};
    packet.source = source;
    packet.num_bytes = static_cast<int32_t>(payload.size());
    packet.payload = payload;
    Publish(listener_, channels::AcousticTx(), packet);
  }
  void SendModemPacket(const std::string& source, const Bytes& payload, double data_rate_bps) {
    modem_tx_t packet = {};
    packet.source = source;
    packet.data_rate_bps = data_rate_bps;
    packet.num_bytes = static_cast<int32_t>(payload.size());
    packet.payload = payload;
    Publish(listener_, channels::ModemTx(), packet);
  }
  void Send(std::string_view rule, const ControlValue& value, const std::string& vehicle = "") {
    unc_control_t control = {};
    SetValue(value, &control);
    control.vehicle = vehicle;
    Publish(listener_, channels::Control(*FindControl(rule)), control);
  }

  /// Lets the broker handle what was published, and receives its answers. The first step is the
  /// mission's first.
  void Step(int64_t pass_us = kStep_us) {
    utime_ = utime_ == 0 ? kStart_utime : utime_ + pass_us;
    for (auto* lists : {&received_, &messages_, &acks_}) {
      for (auto& [name, list] : *lists) list.clear();
    }
    orders_.clear();
    packets_.clear();
    fates_.clear();
    pulses_.clear();
    shared_.clear();
    hub_.NextStep();
    hub_.HandleAll();
    broker_.Tick(utime_);
    hub_.NextStep();
    hub_.HandleAll();
  }

  /// Returns "source>destination cause" of each fate of the step.
  std::vector<std::string> Fates() const {
    std::vector<std::string> texts;
    for (const fate_t& fate : fates_) {
      texts.push_back(fate.source + ">" + fate.destination + " " + fate.cause);
    }
    return texts;
  }

  bool PageHas(const std::string& text) {
    return broker_.Status().text.find(text) != std::string::npos;
  }

  MemoryBus hub_;
  Bus& broker_bus_ = hub_.Join("shore_broker");
  Bus& listener_ = hub_.Join("listener");
  const Mission mission_;
  ShoreBrokerApp broker_{mission_, broker_bus_};
  int64_t utime_ = 0;
  // What was received in the last step, by vehicle where it is one's.
  std::map<std::string, std::vector<Bytes>> received_;
  std::map<std::string, std::vector<Bytes>> messages_;
  std::map<std::string, std::vector<Bytes>> acks_;
  std::map<std::string, std::vector<acoustic_rx_t>> packets_;
  std::map<std::string, std::string> orders_;
  std::vector<fate_t> fates_;
  std::vector<comms_pulse_t> pulses_;
  std::vector<std::string> shared_;  ///< Names.
  // What was received so far.
  std::vector<BrokerRules> rules_;
  int num_requests_ = 0;

 private:
  void Keep(const std::string& channel, std::vector<Bytes>* list) {
    listener_.SubscribeBytes(channel, [list](const Message& message) {
      list->emplace_back(message.data.begin(), message.data.end());
    });
  }
};

}  // namespace shoal
