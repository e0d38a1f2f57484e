#include "tests/netcdf/write_netcdf.h"

#include <netcdf.h>

#include <array>
#include <stdexcept>

namespace shoal {

namespace {

/// By WrittenType.
constexpr std::array<nc_type, 6> kTypes = {NC_BYTE, NC_CHAR, NC_SHORT, NC_INT, NC_FLOAT, NC_DOUBLE};

nc_type TypeOf(WrittenType type) { return kTypes.at(static_cast<size_t>(type)); }

void Demand(int status) {
  if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

void Define(int file, const WrittenVariable& variable) {
  int number = 0;
  Demand(nc_def_var(file, variable.name.c_str(), TypeOf(variable.type),
                    static_cast<int>(variable.dimensions.size()), variable.dimensions.data(),
                    &number));
  for (const auto& [key, text] : variable.texts) {
    Demand(nc_put_att_text(file, number, key.c_str(), text.size(), text.c_str()));
  }
  for (const auto& [key, value] : variable.numbers) {
    const nc_type type = key == "_FillValue" ? TypeOf(variable.type) : NC_DOUBLE;
    Demand(nc_put_att_double(file, number, key.c_str(), type, 1, &value));
  }
}

}  // namespace

void WriteNetcdf(const std::string& path, NetcdfForm form, const WrittenNetcdf& content) {
  int file = 0;
  int fill = 0;
  Demand(nc_create(path.c_str(), form == NetcdfForm::kHdf5 ? NC_NETCDF4 : NC_CLOBBER, &file));
  Demand(nc_set_fill(file, NC_NOFILL, &fill));
  for (const auto& [name, length] : content.dimensions) {
    int number = 0;
    Demand(nc_def_dim(file, name.c_str(), length, &number));
  }
  for (const WrittenVariable& each : content.variables) Define(file, each);
  Demand(nc_enddef(file));
  for (size_t i = 0; i < content.variables.size(); ++i) {
    const std::vector<double>& values = content.variables[i].values;
    if (!values.empty()) Demand(nc_put_var_double(file, static_cast<int>(i), values.data()));
  }
  Demand(nc_close(file));
}

}  // namespace shoal
