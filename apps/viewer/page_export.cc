#include "apps/viewer/page_export.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "apps/viewer/page_channels.h"
#include "apps/viewer/recorded_channels.h"
#include "lib/base/check/check.h"
#include "lib/bus/os/replace_file.h"
#include "lib/tools/page/base64.h"
#include "lib/tools/page/module_bundle.h"
#include "lib/tools/page/script_hash.h"
#include "lib/tools/view/page_recording.h"
#include "lib/tools/view/recorded_view.h"

namespace shoal {

namespace {

/// Returns the value of an attribute of a line of HTML; empty: it has none.
std::string_view AttributeOf(std::string_view line, std::string_view name) {
  const std::string begin = fmt::format(" {}=\"", name);
  const size_t at = line.find(begin);
  if (at == line.npos) return {};
  line.remove_prefix(at + begin.size());
  return line.substr(0, line.find('"'));
}

/// Puts into one page what index.html names, line by line.
class OnePage {
 public:
  explicit OnePage(const PageFiles& files) : files_(files) {}

  Result<std::string> Make(std::string_view recording) {
    const std::string* index = Find("index.html");
    if (index == nullptr) return Error{"the page has no index.html"};
    for (std::string_view rest = *index; !rest.empty();) {
      const size_t end = std::min(rest.find('\n'), rest.size() - 1);
      if (!TakeLine(rest.substr(0, end + 1))) return Error{error_};
      rest.remove_prefix(end + 1);
    }
    const size_t policy = page_.find(kPolicyPlace);
    const size_t body_end = page_.find("</body>");
    if (policy == page_.npos || body_end == page_.npos || script_.empty()) {
      return Error{"index.html has no <meta charset>, no module or no </body> of its own line"};
    }
    page_.insert(body_end,
                 fmt::format("<script type=\"application/json\" id=\"recording\">{}</script>\n"
                             "<script type=\"module\">{}</script>\n",
                             DeflatedBase64(recording), script_));
    page_.replace(policy, kPolicyPlace.size(),
                  fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\""
                              "default-src 'none'; img-src data: blob:; base-uri 'none'; "
                              "form-action 'none'; style-src{}; script-src {}\">\n",
                              style_hashes_, ScriptHash(script_)));
    return std::move(page_);
  }

 private:
  static constexpr std::string_view kPolicyPlace = "{{policy}}";

  const std::string* Find(std::string_view name) const {
    const auto file = files_.find(fmt::format("/{}", name));
    return file == files_.end() ? nullptr : &file->second.bytes;
  }
  bool Fail(std::string error) {
    error_ = std::move(error);
    return false;
  }

  bool TakeLine(std::string_view line) {
    const std::string_view rel = AttributeOf(line, "rel");
    if (line.starts_with("<link ") && rel == "modulepreload") return true;
    if (line.starts_with("<link ")) return TakeLink(rel, AttributeOf(line, "href"));
    if (line.starts_with("<script ")) return TakeScript(AttributeOf(line, "src"));
    page_ += line;
    if (line.starts_with("<meta charset")) page_ += kPolicyPlace;
    return true;
  }
  bool TakeLink(std::string_view rel, std::string_view name) {
    const std::string* text = Find(name);
    if (text == nullptr) return Fail(fmt::format("index.html names {}, which is not there", name));
    if (rel == "stylesheet") {
      style_hashes_ += " " + ScriptHash(*text);
      page_ += fmt::format("<style>{}</style>\n", *text);
      return true;
    }
    page_ +=
        fmt::format("<link rel=\"icon\" href=\"data:image/svg+xml;base64,{}\">\n", Base64(*text));
    return true;
  }
  bool TakeScript(std::string_view name) {
    ModuleTexts modules;
    for (const auto& [path, file] : files_) modules.emplace(path, file.bytes);
    Result<std::string> script = BundleModules(modules, fmt::format("/{}", name));
    if (!script.ok()) return Fail(script.error());
    script_ = std::move(*script);
    if (script_.find("</script") != script_.npos || script_.find("<!--") != script_.npos) {
      return Fail(fmt::format("{} holds what ends a script in HTML", name));
    }
    return true;
  }

  const PageFiles& files_;
  std::string page_;
  std::string script_;
  std::string style_hashes_;
  std::string error_;
};

int Fail(int exit_code, const std::string& why) {
  fmt::print(stderr, "shoal-viewer: {}\n", why);
  return exit_code;
}

std::string SizeText(size_t bytes) {
  const double kilobytes = static_cast<double>(bytes) / 1000;
  return kilobytes < 1000 ? fmt::format("{:.0f} kB", kilobytes)
                          : fmt::format("{:.1f} MB", kilobytes / 1000);
}

}  // namespace

std::string DeflatedBase64(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  const int result =
      compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_BEST_COMPRESSION);
  SHOAL_CHECK(result == Z_OK, "zlib has memory, and as much room as it asks for");
  packed.resize(size);
  return Base64(packed);
}

Result<std::string> SelfContainedPage(const PageFiles& files, std::string_view recording) {
  return OnePage(files).Make(recording);
}

int ExportPage(const PageFiles& files, const ExportOptions& options) {
  Result<std::unique_ptr<RecordedView>> view =
      RecordedView::Open(options.log, {.mission_file = options.mission_file, .boot = "page"});
  if (!view.ok()) return Fail(kExitUsage, view.error());
  RecordedChannels channels(options.log, options.mission_file);
  PageRecordingOptions recording_options = {.step_s = options.step_s};
  recording_options.add_more = [&](nlohmann::json* all, std::vector<std::string>* notes) {
    (*all)["channels"] = ChannelsForPage(channels, (*view)->begin_s(), (*view)->end_s(), {}, notes);
  };
  const PageRecording recording =
      RecordForPage(**view, (*view)->begin_s(), (*view)->end_s(), recording_options);
  const Result<std::string> page = SelfContainedPage(files, recording.json);
  if (!page.ok()) return Fail(kExitUsage, page.error());
  fmt::print("{}: {}, {} frames {:g} s apart, {} fates\n", options.path, SizeText(page->size()),
             recording.num_frames, recording.step_s, recording.num_fates);
  for (size_t i = 1; i < recording.notes.size(); ++i) fmt::print("note: {}\n", recording.notes[i]);
  std::fflush(stdout);
  const std::string error = ReplaceFile(options.path, *page);
  return error.empty() ? kExitOk : Fail(kExitUsage, error);
}

}  // namespace shoal
