#include "lib/comms/moos_wire/moos_database.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "lib/base/text/letters.h"
#include "lib/base/text/terminal_text.h"

namespace shoal {
namespace {

std::string Shown(std::string_view name) { return "'" + TerminalLine(name, 64) + "'"; }

}  // namespace

MoosDatabase::MoosDatabase(MoosDatabaseOptions options)
    : options_(std::move(options)), variables_(options_.limits) {}

void MoosDatabase::Event(std::string text) {
  if (events_.size() < kMaxEvents) events_.push_back(std::move(text));
}

void MoosDatabase::Begin(MoosNow now) {
  if (!std::exchange(has_started_, true)) started_s_ = now.time_s;
}

void MoosDatabase::OnConnect(MoosClientId id, MoosNow now) {
  Begin(now);
  clients_[id].heard_us = now.wall_us;
}

void MoosDatabase::OnClose(MoosClientId id, MoosNow now) {
  const auto found = clients_.find(id);
  if (found == clients_.end()) return;
  const std::string name = std::move(found->second.name);
  clients_.erase(found);
  variables_.Remove(id);
  if (name.empty()) return;
  Event("client " + Shown(name) + " has left");
  WriteOwn(MoosNotify("", "DB_EVENT", "disconnected=" + name), now);
}

void MoosDatabase::OnBytes(MoosClientId id, std::string_view bytes, MoosNow now) {
  const auto found = clients_.find(id);
  if (found == clients_.end() || found->second.is_closing) return;
  Client& client = found->second;
  client.heard_us = now.wall_us;
  if (client.greeting.size() < kMoosGreetingBytes) {
    const size_t missing = std::min(kMoosGreetingBytes - client.greeting.size(), bytes.size());
    client.greeting += bytes.substr(0, missing);
    bytes.remove_prefix(missing);
    if (client.greeting.size() < kMoosGreetingBytes) return;
    if (client.greeting != MoosGreeting()) {
      ++counts_.broken;
      Event("a connection was closed: it does not begin with the name of MOOS's protocol");
      client.is_closing = true;
      return;
    }
  }
  OnPackets(id, &client, bytes, now);
}

void MoosDatabase::OnPackets(MoosClientId id, Client* client, std::string_view bytes, MoosNow now) {
  client->reader.Take(bytes, [&](std::span<const MoosMessage> messages) {
    for (const MoosMessage& message : messages) {
      if (client->is_closing) return;
      OnMessage(id, client, message, now);
    }
  });
  if (client->is_closing || client->reader.problem().empty()) return;
  ++counts_.broken;
  Event((client->name.empty() ? "a connection" : "client " + Shown(client->name)) +
        " was closed: " + client->reader.problem());
  client->is_closing = true;
}

void MoosDatabase::Refuse(Client* client, const std::string& reason) {
  ++counts_.refused;
  Event("a client was refused: " + TerminalLine(reason, 200));
  MoosMessage poison = MoosNotify("", "", reason);
  poison.type = moos_type::kPoison;
  AppendMoosPacket({&poison, 1}, &client->handshake);
  client->is_closing = true;
}

void MoosDatabase::Join(Client* client, const MoosMessage& message, MoosNow now) {
  const std::string& name = message.text;
  if (message.type != moos_type::kData || message.key != kMoosAsynchronous) {
    Refuse(client, "Only asynchronous clients are served");
    return;
  }
  if (name.empty() || name.size() > kLongestName) {
    Refuse(client, "The name of a client has 1 to 128 bytes");
    return;
  }
  const bool is_taken = name == options_.own_name ||
                        std::any_of(clients_.begin(), clients_.end(), [&](const auto& entry) {
                          return entry.second.name == name && !entry.second.is_closing;
                        });
  if (is_taken) {
    Refuse(client, "A client of this name (\"" + name + "\") already exists");
    return;
  }
  client->name = name;
  ++counts_.joined;
  const MoosMessage welcome = {.type = moos_type::kWelcome,
                               .source_aux = "hostname=" + options_.host,
                               .community = options_.community,
                               .time_s = now.time_s,
                               .value = now.time_s - message.time_s,
                               .text = std::string(kMoosAsynchronous)};
  AppendMoosPacket({&welcome, 1}, &client->handshake);
  Event("client " + Shown(name) + " has joined");
  WriteOwn(MoosNotify("", "DB_EVENT", "connected=" + name), now);
  UpdateOwn(now);
}

void MoosDatabase::OnMessage(MoosClientId id, Client* client, const MoosMessage& message,
                             MoosNow now) {
  if (client->name.empty()) {
    Join(client, message, now);
    return;
  }
  MoosMail mail;
  switch (message.type) {
    case moos_type::kTiming:
      client->answers.push_back(message);
      client->answers.back().value = now.time_s;
      client->answers.back().value2 = 0;
      break;
    case moos_type::kRegister:
      variables_.Subscribe(id, message.key, message.value, now.time_s, &mail);
      break;
    case moos_type::kUnregister:
      variables_.Unsubscribe(id, message.key);
      break;
    case moos_type::kWildcardRegister:
      variables_.SubscribePattern(id, ParseMoosPattern(message.text), now.time_s, &mail);
      break;
    case moos_type::kWildcardUnregister:
      variables_.UnsubscribePattern(id, ParseMoosPattern(message.text));
      break;
    case moos_type::kNotify:
      TakeNotify(*client, message, now);
      break;
    case moos_type::kNull:
      break;
    default:
      ++counts_.requests;
  }
  Deliver(std::move(mail));
}

void MoosDatabase::TakeNotify(const Client& client, const MoosMessage& message, MoosNow now) {
  MoosMessage written = message;
  if (written.source.empty()) written.source = client.name;
  if (written.community.empty()) written.community = options_.community;
  if (!WriteMessage(written, now)) return;
  if (mail_.size() < kMaxMail) {
    mail_.push_back(std::move(written));
  } else {
    ++counts_.lost;
  }
}

bool MoosDatabase::WriteMessage(const MoosMessage& message, MoosNow now) {
  MoosMail mail;
  const bool is_taken = variables_.Write(message, now.time_s, &mail);
  Deliver(std::move(mail));
  return is_taken;
}

void MoosDatabase::WriteOwn(MoosMessage message, MoosNow now) {
  message.source = "MOOSDB_" + options_.community;
  message.community = options_.community;
  message.time_s = now.time_s;
  WriteMessage(message, now);
}

void MoosDatabase::UpdateOwn(MoosNow now) {
  updated_s_ = now.time_s;
  WriteOwn(MoosNotify("", "DB_TIME", now.time_s), now);
  WriteOwn(MoosNotify("", "DB_UPTIME", now.time_s - started_s_), now);
  WriteOwn(MoosNotify("", "DB_CLIENTS", ClientList()), now);
}

std::vector<std::string> MoosDatabase::ClientNames() const {
  std::vector<std::string> names;
  for (const auto& [id, client] : clients_) {
    if (!client.name.empty()) names.push_back(client.name);
  }
  return names;
}

std::string MoosDatabase::ClientList() const {
  std::string list;
  if (!options_.own_name.empty()) list = options_.own_name + ",";
  for (const std::string& name : ClientNames()) list += name + ",";
  return list;
}

void MoosDatabase::Write(std::string_view key, double value, MoosNow now) {
  MoosMessage message = MoosNotify(options_.own_name, key, value);
  message.id = next_id_;
  next_id_ = next_id_ == INT32_MAX ? 0 : next_id_ + 1;
  message.community = options_.community;
  message.time_s = now.time_s;
  WriteMessage(message, now);
}

void MoosDatabase::Write(std::string_view key, std::string_view text, MoosNow now) {
  MoosMessage message = MoosNotify(options_.own_name, key, text);
  message.id = next_id_;
  next_id_ = next_id_ == INT32_MAX ? 0 : next_id_ + 1;
  message.community = options_.community;
  message.time_s = now.time_s;
  WriteMessage(message, now);
}

void MoosDatabase::Deliver(MoosMail mail) {
  for (auto& [id, message] : mail) {
    const auto found = clients_.find(id);
    if (found == clients_.end() || found->second.is_closing) continue;
    Client& client = found->second;
    client.num_mail_bytes += MoosMessageBytes(message);
    if (client.num_mail_bytes <= kMaxWaitingBytes) {
      client.mail.push_back(std::move(message));
      continue;
    }
    ++counts_.slow;
    Event("client " + Shown(client.name) + " was closed: it asked for more than it can take");
    client.mail.clear();
    client.is_closing = true;
  }
}

void MoosDatabase::Advance(MoosNow now) {
  Begin(now);
  if (now.time_s - updated_s_ >= kOwnInterval_s) UpdateOwn(now);
  for (auto& [id, client] : clients_) {
    if (client.is_closing || now.wall_us - client.heard_us < kSilence_us) continue;
    ++counts_.silent;
    Event((client.name.empty() ? "a connection that did not introduce itself"
                               : "client " + Shown(client.name)) +
          " was closed: silent for 5 s");
    client.is_closing = true;
  }
}

std::vector<MoosOutput> MoosDatabase::TakeOutput() {
  std::vector<MoosOutput> output;
  for (auto& [id, client] : clients_) {
    if (client.is_closed) continue;
    // A real client expects the answer to its timing first in a packet.
    std::vector<MoosMessage> messages = std::exchange(client.answers, {});
    std::move(client.mail.begin(), client.mail.end(), std::back_inserter(messages));
    client.mail.clear();
    client.num_mail_bytes = 0;
    MoosOutput each = {.client = id, .bytes = std::exchange(client.handshake, {})};
    AppendMoosPackets(messages, &each.bytes);
    each.closes = client.is_closed = client.is_closing;
    if (!each.bytes.empty() || each.closes) output.push_back(std::move(each));
  }
  return output;
}

std::vector<MoosMessage> MoosDatabase::TakeMail() { return std::exchange(mail_, {}); }

std::vector<std::string> MoosDatabase::TakeEvents() { return std::exchange(events_, {}); }

}  // namespace shoal
