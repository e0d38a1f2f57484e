#include "apps/netcdf_reader/answer.h"

#include <netcdf.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/netcdf_reader/classic_size.h"
#include "lib/bus/os/file_bytes.h"
#include "lib/mission/netcdf/netcdf_wire.h"

namespace shoal {

namespace {

constexpr int kFileDescriptor = 3;
constexpr char kFile[] = "/proc/self/fd/3";
constexpr rlim_t kMaxMemory_bytes = rlim_t{1} << 30;
constexpr rlim_t kMaxCpu_s = 10;
/// 0 to 3, and the file once more as libnetcdf opens it. From then on nothing can be opened at all:
/// values of HDF5 may be stored in other files, of any path, that the file names.
constexpr rlim_t kMaxOpenFiles = 5;
constexpr char kElsewhere[] =
    "its values are in another file, which it names (HDF5 external or virtual storage), and no "
    "other "
    "file is opened: copy them into one file, for example with nccopy";

void Limit(int resource, rlim_t most) {
  const rlimit limit = {most, most};
  setrlimit(static_cast<__rlimit_resource>(resource), &limit);
}

void LimitThisProcess() {
  // Filters of HDF5 are code that is loaded from a folder: none is.
  setenv("HDF5_PLUGIN_PRELOAD", "::", 1);
  // Nor are the settings of libnetcdf in the working folder and in that of the user.
  setenv("NCRCENV_IGNORE", "1", 1);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  Limit(RLIMIT_AS, kMaxMemory_bytes);
#endif
  Limit(RLIMIT_CPU, kMaxCpu_s);
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_FSIZE, 0);
  Limit(RLIMIT_NOFILE, kMaxOpenFiles);
}

/// Why there is no answer.
struct Refusal {
  std::string text;
};

void Demand(int status, const char* what) {
  if (status == NC_NOERR) return;
  throw Refusal{std::string(what) + ": " + nc_strerror(status) +
                "; is it a NetCDF file, and whole? Look at it with ncdump -h"};
}

NetcdfType TypeOf(nc_type type) {
  switch (type) {
    case NC_BYTE:
    case NC_UBYTE:
      return NetcdfType::kByte;
    case NC_SHORT:
      return NetcdfType::kShort;
    case NC_INT:
      return NetcdfType::kInt;
    case NC_INT64:
      return NetcdfType::kInt64;
    case NC_USHORT:
      return NetcdfType::kUnsignedShort;
    case NC_UINT:
      return NetcdfType::kUnsignedInt;
    case NC_UINT64:
      return NetcdfType::kUnsignedInt64;
    case NC_FLOAT:
      return NetcdfType::kFloat;
    case NC_DOUBLE:
      return NetcdfType::kDouble;
    default:
      return NetcdfType::kOther;
  }
}

std::string StringOf(int file, int variable, const char* name, size_t length) {
  std::vector<char*> texts(length, nullptr);
  Demand(nc_get_att_string(file, variable, name, texts.data()), "an attribute cannot be read");
  std::string text = length > 0 && texts[0] != nullptr ? texts[0] : "";
  nc_free_string(length, texts.data());
  return text;
}

NetcdfAttribute AttributeOf(int file, int variable, int number) {
  std::array<char, NC_MAX_NAME + 1> name{};
  nc_type type = NC_NAT;
  size_t length = 0;
  Demand(nc_inq_attname(file, variable, number, name.data()), "an attribute has no name");
  Demand(nc_inq_att(file, variable, name.data(), &type, &length), "an attribute cannot be read");
  NetcdfAttribute attribute{.name = name.data()};
  if (type == NC_CHAR && length <= size_t{1} << 20) {
    std::string text(length, '\0');
    Demand(nc_get_att_text(file, variable, name.data(), text.data()), "a text cannot be read");
    attribute.text = text.substr(0, text.find('\0'));
  } else if (type == NC_STRING && length <= kMaxNetcdfNumbers) {
    attribute.text = StringOf(file, variable, name.data(), length);
  } else if (TypeOf(type) != NetcdfType::kOther && length <= kMaxNetcdfNumbers) {
    attribute.type = TypeOf(type);
    attribute.numbers.resize(length);
    Demand(nc_get_att_double(file, variable, name.data(), attribute.numbers.data()),
           "an attribute cannot be read");
  }
  return attribute;
}

void DemandFew(int count, const char* what) {
  if (count >= 0 && static_cast<size_t>(count) <= kMaxNetcdfNames) return;
  throw Refusal{"it has " + std::to_string(count) + " " + what + ", and at most " +
                std::to_string(kMaxNetcdfNames) +
                " are read; cut out the variables that the mission needs (ncks -v)"};
}

NetcdfVariable VariableOf(int file, int number, int num_dimensions) {
  std::array<char, NC_MAX_NAME + 1> name{};
  nc_type type = NC_NAT;
  int rank = 0;
  int num_attributes = 0;
  Demand(nc_inq_varndims(file, number, &rank), "a variable cannot be read");
  DemandFew(rank, "dimensions of a variable");
  std::vector<int> dimensions(static_cast<size_t>(rank) + 1);
  Demand(nc_inq_var(file, number, name.data(), &type, &rank, dimensions.data(), &num_attributes),
         "a variable cannot be read");
  dimensions.resize(static_cast<size_t>(rank));
  DemandFew(num_attributes, "attributes of a variable");
  NetcdfVariable variable{.name = name.data(), .type = TypeOf(type)};
  for (const int dimension : dimensions) {
    if (dimension < 0 || dimension >= num_dimensions) {
      throw Refusal{"a variable has a dimension that the file does not have; it is damaged"};
    }
    variable.dimensions.push_back(static_cast<uint32_t>(dimension));
  }
  for (int i = 0; i < num_attributes; ++i) {
    variable.attributes.push_back(AttributeOf(file, number, i));
  }
  return variable;
}

NetcdfHeader HeaderOf(int file) {
  int num_dimensions = 0;
  int num_variables = 0;
  Demand(nc_inq(file, &num_dimensions, &num_variables, nullptr, nullptr), "it cannot be read");
  DemandFew(num_dimensions, "dimensions");
  DemandFew(num_variables, "variables");
  NetcdfHeader header;
  for (int i = 0; i < num_dimensions; ++i) {
    std::array<char, NC_MAX_NAME + 1> name{};
    size_t length = 0;
    Demand(nc_inq_dim(file, i, name.data(), &length), "a dimension cannot be read");
    header.dimensions.push_back({.name = name.data(), .length = length});
  }
  for (int i = 0; i < num_variables; ++i) {
    header.variables.push_back(VariableOf(file, i, num_dimensions));
  }
  return header;
}

/// Reads the values of a variable, which are as many as there is room for. Where they are in
/// another file that is EMFILE in errno: the library returns an error of HDF5 for external storage.
/// Parts of a virtual one that it cannot open it fills in without an error.
int ReadValues(int file, int number, std::vector<double>& values) {
  int storage = NC_CONTIGUOUS;
  nc_inq_var_chunking(file, number, &storage, nullptr);
  if (storage == NC_VIRTUAL || storage == NC_UNKNOWN_STORAGE) {  // As it calls virtual ones.
    errno = EMFILE;
    return NC_EHDFERR;
  }
  errno = 0;
  const int status = nc_get_var_double(file, number, values.data());
  return status == NC_NOERR && errno == EMFILE ? NC_EHDFERR : status;
}

/// Appends the values of coordinate variables, so that they need no question of their own. What
/// cannot be read is left out: the question for it shows why.
void AddCoordinates(int file, const NetcdfHeader& header, NetcdfReplyWriter* writer) {
  for (size_t i = 0; i < header.variables.size(); ++i) {
    const NetcdfVariable& variable = header.variables[i];
    if (!IsCoordinate(header, variable)) continue;
    std::vector<double> values(header.NumValues(variable));
    if (ReadValues(file, static_cast<int>(i), values) != NC_NOERR) continue;
    writer->AddText(variable.name);
    writer->AddNumbers(values.data(), values.size());
  }
  writer->AddText("");
}

std::vector<double> ValuesOf(int file, const std::string& name, uint64_t count) {
  const NetcdfHeader header = HeaderOf(file);
  const NetcdfVariable* variable = header.Find(name);
  if (variable == nullptr || header.NumValues(*variable) != count || count > kMaxNetcdfValues) {
    throw Refusal{"it has changed while it was read; start again"};
  }
  int number = 0;
  Demand(nc_inq_varid(file, name.c_str(), &number), "it cannot be read");
  std::vector<double> values(count);
  const int status = ReadValues(file, number, values);
  // The library has no error of its own for a file that it could not open.
  if (status == NC_EHDFERR && errno == EMFILE) throw Refusal{kElsewhere};
  // A number beyond a double's range is still a number.
  if (status != NC_ERANGE) Demand(status, "its values cannot be read");
  return values;
}

void WriteAnswer(char kind, const NetcdfReplyWriter& body) {
  std::string answer(kNetcdfGreeting);
  answer += kind;
  answer += body.bytes();
  answer += kNetcdfEnd;
  if (!WriteAll(STDOUT_FILENO, answer)) _exit(1);
}

/// Refuses a file of a classic form that ends before its last value.
void DemandWhole() {
  constexpr size_t kMaxHeader_bytes = size_t{4} << 20;
  struct stat status {};
  if (fstat(kFileDescriptor, &status) != 0) return;
  const auto size = static_cast<uint64_t>(status.st_size);
  std::vector<uint8_t> head(std::min<uint64_t>(size, kMaxHeader_bytes));
  const ssize_t count = pread(kFileDescriptor, head.data(), head.size(), 0);
  head.resize(static_cast<size_t>(std::max<ssize_t>(count, 0)));
  const std::optional<uint64_t> end = ClassicDataEnd(head);
  const bool is_classic = head.size() > 3 && std::equal(head.begin(), head.begin() + 3, "CDF");
  if (is_classic && !end && head.size() == size) {
    throw Refusal{"it ends within its header: it was cut off, copy or download it again"};
  }
  if (!end || *end <= size) return;
  throw Refusal{"it has " + std::to_string(size) + " bytes, and its values end at " +
                std::to_string(*end) + ": it was cut off, copy or download it again"};
}

void Answer(const std::vector<std::string>& words) {
  DemandWhole();
  int file = 0;
  Demand(nc_open(kFile, NC_NOWRITE, &file), "it cannot be opened");
  Limit(RLIMIT_NOFILE, 0);
  NetcdfReplyWriter body;
  if (words[0] == "header") {
    const NetcdfHeader header = HeaderOf(file);
    AddHeader(header, &body);
    AddCoordinates(file, header, &body);
    WriteAnswer('H', body);
  } else {
    const std::vector<double> values =
        ValuesOf(file, words[1], std::strtoull(words[2].c_str(), nullptr, 10));
    body.AddNumbers(values.data(), values.size());
    WriteAnswer('V', body);
  }
}

}  // namespace

void AnswerNetcdf(const std::vector<std::string>& question) {
  LimitThisProcess();
  std::string refusal;
  try {
    Answer(question);
    // What libnetcdf would still do is of no use, and it crashes there too.
    _exit(0);
  } catch (const Refusal& each) {
    refusal = each.text;
  } catch (const std::bad_alloc&) {
    refusal = "reading it takes more than 1 GiB of memory; cut out the part that the mission needs";
  }
  NetcdfReplyWriter body;
  body.AddText(refusal);
  WriteAnswer('E', body);
  _exit(0);
}

}  // namespace shoal
