#include "apps/viewer/plan_desk.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "apps/viewer/plan_runs.h"
#include "lib/bus/os/file_descriptor.h"
#include "lib/bus/os/read_file.h"
#include "lib/mission/file/load.h"
#include "lib/tools/view/json_writer.h"
#include "lib/tools/view/plan_json.h"

namespace shoal {

namespace {

constexpr int kMaxPlans = 999;

/// Returns the text of a question, edited; or why there is none.
Result<std::string> TextOf(const PlanQuestion& question, const std::string& file) {
  std::string text;
  if (question.text) {
    text = *question.text;
  } else {
    FileText read = ReadRegularFile(file, kLargestRunFile_bytes);
    if (!read.problem.empty()) return Error{fmt::format("{}: {}", file, read.problem)};
    text = std::move(read.text);
  }
  if (text.size() > PlanDesk::kMaxText_bytes) {
    return Error{fmt::format("{} is larger than {} kB: edit it with an editor", file,
                             PlanDesk::kMaxText_bytes / 1000)};
  }
  return question.edit ? EditPlan(text, *question.edit) : Result<std::string>(std::move(text));
}

/// Writes a new file, "berta_plan1.toml" beside "berta.toml" or a later number: never over one that
/// is there. Returns its path.
Result<std::string> WriteBeside(const std::string& file, const std::string& text) {
  namespace fs = std::filesystem;
  const fs::path path(file);
  std::string stem = path.stem().string();
  // The plan of a plan is the next one.
  if (const size_t at = stem.rfind("_plan");
      at != stem.npos && at > 0 && stem.find_first_not_of("0123456789", at + 5) == stem.npos) {
    stem.erase(at);
  }
  for (int number = 1; number <= kMaxPlans; ++number) {
    const fs::path plan = path.parent_path() / fmt::format("{}_plan{}.toml", stem, number);
    const FileDescriptor made(
        open(plan.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644));
    if (made.get() < 0 && errno == EEXIST) continue;
    size_t done = 0;
    while (made.get() >= 0 && done < text.size()) {
      const ssize_t size = write(made.get(), text.data() + done, text.size() - done);
      if (size <= 0) break;
      done += static_cast<size_t>(size);
    }
    if (made.get() < 0 || done < text.size()) {
      return Error{fmt::format("cannot write {}: {}", plan.string(), std::strerror(errno))};
    }
    return plan.string();
  }
  return Error{fmt::format("there are {} plans beside {}: remove some", kMaxPlans, file)};
}

WebAnswer FileAnswer(const std::string& file, const std::string& url) {
  JsonWriter json;
  json.BeginObject().Text("file", file);
  if (!url.empty()) json.Text("url", url);
  json.EndObject();
  return {.body = json.Take()};
}

}  // namespace

PlanDesk::PlanDesk(bool may_write, std::function<PlanFile()> file)
    : may_write_(may_write),
      file_(std::move(file)),
      runs_(may_write ? std::make_unique<PlanRuns>() : nullptr) {}

PlanDesk::~PlanDesk() = default;

WebAnswer PlanDesk::Look(std::string_view body) {
  const Result<PlanQuestion> question = ParsePlanQuestion(body);
  if (!question.ok()) return ErrorAnswer(400, question.error());
  const PlanFile file = file_();
  if (file.file.empty()) return ErrorAnswer(404, "no mission file is known here");
  const Result<std::string> text = TextOf(*question, file.file);
  if (!text.ok()) return ErrorAnswer(400, text.error());
  return {.body = PlanJson(
              *text, {.file = file.file, .overrides = file.overrides, .may_write = may_write_})};
}

std::string PlanDesk::WriteNew(std::string_view body, WebAnswer* refusal) {
  const auto refuse = [&](int status, const std::string& why) {
    *refusal = ErrorAnswer(status, why);
    return std::string();
  };
  const Result<PlanQuestion> question = ParsePlanQuestion(body);
  if (!question.ok()) return refuse(400, question.error());
  if (!question->text) return refuse(400, "this needs \"text\", the mission to write");
  const PlanFile file = file_();
  if (file.file.empty()) return refuse(404, "no mission file is known here");
  const Result<std::string> text = TextOf(*question, file.file);
  if (!text.ok()) return refuse(400, text.error());
  const LoadedMission loaded = LoadMissionText(*text, file.file, file.overrides);
  if (!loaded.errors.empty()) return refuse(400, loaded.errors.front());
  Result<std::string> path = WriteBeside(file.file, *text);
  if (!path.ok()) return refuse(400, path.error());
  return *path;
}

WebAnswer PlanDesk::Write(std::string_view body) {
  if (!may_write_)
    return ErrorAnswer(403, "this viewer writes no files: --allow-commands allows it");
  WebAnswer refusal;
  const std::string path = WriteNew(body, &refusal);
  return path.empty() ? refusal : FileAnswer(path, "");
}

WebAnswer PlanDesk::Run(std::string_view body) {
  if (!runs_) return ErrorAnswer(403, "this viewer starts no missions: --allow-commands allows it");
  WebAnswer refusal;
  const std::string path = WriteNew(body, &refusal);
  if (path.empty()) return refusal;
  const Result<std::string> url = runs_->Start(path, file_().overrides);
  return url.ok() ? FileAnswer(path, *url) : ErrorAnswer(400, url.error());
}

}  // namespace shoal
