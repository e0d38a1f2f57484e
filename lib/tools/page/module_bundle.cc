#include "lib/tools/page/module_bundle.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <vector>

namespace shoal {

namespace {

constexpr std::string_view kImport = "import ";
constexpr std::string_view kExport = "export ";

bool IsOfName(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_' || letter == '$';
}

std::string_view FirstName(std::string_view text) {
  const auto end = std::find_if_not(text.begin(), text.end(), IsOfName);
  return text.substr(0, static_cast<size_t>(end - text.begin()));
}

std::string_view TakeLine(std::string_view* text) {
  const size_t end = text->find('\n');
  const size_t size = end == text->npos ? text->size() : end + 1;
  const std::string_view line = text->substr(0, size);
  text->remove_prefix(size);
  return line;
}

/// Returns the name that the rest of a line behind "export " declares.
std::string_view DeclaredName(std::string_view rest) {
  for (const std::string_view word : {"async ", "function* ", "function ", "class ", "const "}) {
    if (rest.starts_with(word)) rest.remove_prefix(word.size());
  }
  return FirstName(rest);
}

class Bundle {
 public:
  explicit Bundle(const ModuleTexts& modules) : modules_(modules) {}

  /// Appends the module and those that it imports, unless they are there; returns its variable.
  Result<std::string> Add(const std::string& path) {
    if (const auto it = variables_.find(path); it != variables_.end()) {
      if (it->second.empty()) return Error{fmt::format("{} imports itself, by others", path)};
      return it->second;
    }
    const auto module = modules_.find(path);
    if (module == modules_.end()) return Error{fmt::format("the page has no {}", path)};
    variables_[path] = {};
    Result<std::string> body = BodyOf(path, module->second);
    if (!body.ok()) return body;
    const std::string variable = fmt::format("module{}", ++num_);
    script_ += fmt::format("const {} = (() => {{\n{}}})();\n", variable, *body);
    variables_[path] = variable;
    return variable;
  }
  std::string Take() { return std::move(script_); }

 private:
  Result<std::string> BodyOf(const std::string& path, std::string_view text) {
    std::string body;
    std::string exports;
    bool is_comment = false;
    while (!text.empty()) {
      std::string_view line = TakeLine(&text);
      is_comment = is_comment || line.starts_with("/*");
      if (is_comment) {
        is_comment = line.find("*/") == line.npos;
        body += line;
      } else if (line.starts_with(kImport)) {
        std::string statement(line);
        while (statement.find(';') == statement.npos && !text.empty()) statement += TakeLine(&text);
        Result<std::string> imported = Imported(path, statement);
        if (!imported.ok()) return imported;
        body += *imported;
      } else if (line.starts_with("export {")) {
        const std::string_view name = FirstName(line.substr(line.find_first_not_of(" {", 7)));
        exports += fmt::format("default: {}, ", name);
      } else {
        if (line.starts_with(kExport)) {
          line.remove_prefix(kExport.size());
          exports += fmt::format("{}, ", DeclaredName(line));
        }
        body += line;
      }
    }
    return body + fmt::format("return {{{}}};\n", exports);
  }

  /// Returns what is in place of an import statement of the module `path`.
  Result<std::string> Imported(const std::string& path, std::string_view statement) {
    const size_t open = statement.find('\'');
    const size_t close = statement.find('\'', open + 1);
    const size_t from = statement.find(" from ");
    if (open == statement.npos || close == statement.npos || from == statement.npos) {
      return Error{fmt::format("{}: an import of another form: {}", path, statement)};
    }
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const std::string_view target = statement.substr(open + 1, close - open - 1);
    const Result<std::string> variable = Add((folder / target).lexically_normal().generic_string());
    if (!variable.ok()) return Error{variable.error()};
    std::string_view names = statement.substr(kImport.size(), from - kImport.size());
    if (!names.starts_with('{')) return fmt::format("const {} = {}.default;\n", names, *variable);
    std::string taken(names);
    for (size_t at; (at = taken.find(" as ")) != taken.npos;) taken.replace(at, 4, ": ");
    return fmt::format("const {} = {};\n", taken, *variable);
  }

  const ModuleTexts& modules_;
  std::map<std::string, std::string> variables_;  ///< Of modules; empty while it is being read.
  std::string script_;
  int num_ = 0;  ///< Of the modules in it.
};

}  // namespace

Result<std::string> BundleModules(const ModuleTexts& modules, const std::string& entry) {
  Bundle bundle(modules);
  const Result<std::string> variable = bundle.Add(entry);
  if (!variable.ok()) return Error{variable.error()};
  return bundle.Take();
}

}  // namespace shoal
