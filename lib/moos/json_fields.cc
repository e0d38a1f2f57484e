#include "lib/moos/json_fields.h"

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "lib/mission/suggest.h"

namespace shoal {
namespace {

using nlohmann::json;

/// Gathers the members of the outermost object, and writes what is below them as JSON again.
class MemberSink final : public nlohmann::json_sax<json> {
 public:
  bool null() override { return Token("null"); }
  bool boolean(bool value) override { return Token(value ? "true" : "false"); }
  bool number_integer(int64_t value) override { return Token(std::to_string(value)); }
  bool number_unsigned(uint64_t value) override { return Token(std::to_string(value)); }
  bool number_float(double, const std::string& written) override { return Token(written); }
  bool string(std::string& value) override {
    if (depth_ <= 1) return Token(value);
    std::string quoted;
    AppendJsonString(value, &quoted);
    return Token(quoted);
  }
  bool binary(json::binary_t&) override { return false; }
  bool start_object(size_t) override { return Open('{'); }
  bool start_array(size_t) override { return Open('['); }
  bool end_object() override { return Close('}'); }
  bool end_array() override { return Close(']'); }
  bool key(std::string& name) override {
    if (depth_ == 1) {
      fields.push_back({name, ""});
    } else {
      SeparateBelow();
      AppendJsonString(name, &fields.back().value);
      fields.back().value += ':';
    }
    return true;
  }
  bool parse_error(size_t byte, const std::string& last_token,
                   const nlohmann::detail::exception&) override {
    problem = fmt::format("the JSON is broken at byte {}, near {}", byte, Quoted(last_token));
    return false;
  }

  std::vector<MoosField> fields;
  std::string problem;

 private:
  bool Token(std::string_view text) {
    if (depth_ > 1) SeparateBelow();
    fields.back().value += text;
    return true;
  }

  bool Open(char bracket) {
    if (depth_ > 1) SeparateBelow();
    if (depth_ > 0) fields.back().value += bracket;
    ++depth_;
    return true;
  }

  bool Close(char bracket) {
    --depth_;
    if (depth_ > 0) fields.back().value += bracket;
    return true;
  }

  /// Appends a comma where an array or object below the outermost has a member already.
  void SeparateBelow() {
    std::string& value = fields.back().value;
    const char last = value.back();
    if (last != '{' && last != '[' && last != ':') value += ',';
  }

  size_t depth_ = 0;
};

}  // namespace

Result<std::vector<MoosField>> ParseJsonFields(std::string_view text) {
  if (!Trimmed(text).starts_with('{')) return Error{"JSON text must begin with '{'"};
  MemberSink sink;
  if (!json::sax_parse(text.begin(), text.end(), &sink)) return Error{std::move(sink.problem)};
  return std::move(sink.fields);
}

void AppendJsonString(std::string_view text, std::string* out) {
  *out += json(text).dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace shoal
