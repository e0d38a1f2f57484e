// Reads NetCDF files, classic and NetCDF-4 (HDF5), by the program shoal-netcdf.
//
//   Result<NetcdfFile> file = NetcdfFile::Open(fd, "tide.nc");
//   const NetcdfVariable* u = file->header().Find("u");
//   Result<std::vector<double>> values = file->Read(*u);
//
// libnetcdf 4.9.0 crashes on some damaged files. So no process of shoal links it: shoal-netcdf
// does, a process of its own for each question, with limits of memory and time, which opens no file
// but this one. Whatever happens
// there is an error here.
#pragma once

#include <sys/types.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lib/base/check/result.h"
#include "lib/mission/netcdf/netcdf_header.h"

namespace shoal {

/// Starts a process that answers a question (apps/netcdf_reader) about the file `file_fd` on
/// `answer_fd`, and closes both at its end. Returns an errno; 0: `pid` runs.
using NetcdfReaderStart = std::function<int(const std::vector<std::string>& question, int file_fd,
                                            int answer_fd, pid_t* pid)>;

/// Starts the program shoal-netcdf.
[[nodiscard]] int StartNetcdfReader(const std::vector<std::string>& question, int file_fd,
                                    int answer_fd, pid_t* pid);

class NetcdfFile {
 public:
  /// A reader limits its own CPU time to 10 s; this is for one that waits for something.
  static constexpr double kLongestAnswer_s = 120;

  /// Reads what the file holds. `fd` is a regular file that is open for reading, and stays so while
  /// this lives; `name` is what messages call it. A reader that has not answered after
  /// `longest_answer_s` is ended. An error begins with the name.
  [[nodiscard]] static Result<NetcdfFile> Open(int fd, const std::string& name,
                                               NetcdfReaderStart start = StartNetcdfReader,
                                               double longest_answer_s = kLongestAnswer_s);

  const NetcdfHeader& header() const { return header_; }
  const std::string& name() const { return name_; }

  /// Returns the values of a variable of header(), as they are in the file: packed ones are not
  /// unpacked, the last dimension varies fastest. An error names file, variable and remedy.
  [[nodiscard]] Result<std::vector<double>> Read(const NetcdfVariable& variable) const;

 private:
  NetcdfFile(int fd, std::string name, NetcdfReaderStart start, double longest_answer_s)
      : fd_(fd),
        name_(std::move(name)),
        start_(std::move(start)),
        longest_answer_s_(longest_answer_s) {}

  Result<std::string> Ask(const std::vector<std::string>& question, char wanted,
                          size_t most_bytes) const;

  int fd_;
  std::string name_;
  NetcdfReaderStart start_;
  double longest_answer_s_;
  NetcdfHeader header_;
  std::map<std::string, std::vector<double>> coordinates_;  ///< What came with the header.
};

/// Returns the path of shoal-netcdf: beside the program or the library that this code is part of,
/// as built or as installed. Its name alone where it is not there: then the PATH is searched.
[[nodiscard]] std::string FindNetcdfReader();

}  // namespace shoal
