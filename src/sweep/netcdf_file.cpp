#include "netcdf_file.hpp"

#include <fcntl.h>
#include <netcdf.h>
#include <unistd.h>

#include <algorithm>

#include "turgor/base/errors.hpp"

namespace turgor {

namespace {

/// A block of an array: where it starts and how far it goes along each dimension.
struct Slab {
  std::vector<std::size_t> start;
  std::vector<std::size_t> count;
  std::size_t size;
};

/// The largest block that is consecutive in the file, starts at an element and has no more than `most` elements.
Slab slab_at(const std::vector<std::size_t>& shape, std::size_t first, std::size_t most) {
  Slab slab{std::vector<std::size_t>(shape.size()), std::vector<std::size_t>(shape.size(), 1), 1};
  std::size_t rest = first;
  for (std::size_t d = shape.size(); d-- > 0;) {
    slab.start[d] = rest % shape[d];
    rest /= shape[d];
  }
  for (std::size_t d = shape.size(); d-- > 0;) {
    slab.count[d] = std::min(shape[d] - slab.start[d], most / slab.size);
    slab.size *= slab.count[d];
    if (slab.count[d] < shape[d]) break;  // not whole: the next row of it is not consecutive
  }
  return slab;
}

template <class Value, class Put>
void put_run(const NetcdfFile::Variable& variable, std::size_t first, std::span<const Value> values, const Put& put) {
  for (std::size_t at = 0; at < values.size();) {
    const Slab slab = slab_at(variable.shape, first + at, values.size() - at);
    put(slab.start.data(), slab.count.data(), values.data() + at);
    at += slab.size;
  }
}

int id_of(const NetcdfFile::Variable* variable) { return variable != nullptr ? variable->id : NC_GLOBAL; }

}  // namespace

void NetcdfFile::check(int status) const {
  if (status == NC_NOERR) return;
  throw ComputationFailed("cannot write " + path_.string() + " (" + nc_strerror(status) +
                          "): is the disk full? Every member is kept; make room and go on with --resume");
}

NetcdfFile::NetcdfFile(std::filesystem::path file) : path_(std::move(file)) {
  check(nc_create(path_.c_str(), NC_NETCDF4 | NC_CLOBBER, &id_));
}

NetcdfFile::~NetcdfFile() {
  if (id_ >= 0) nc_close(id_);
}

NetcdfFile::Dimension NetcdfFile::dimension(const std::string& name, std::size_t length) {
  Dimension dimension{0, length};
  check(nc_def_dim(id_, name.c_str(), length, &dimension.id));
  return dimension;
}

NetcdfFile::Variable NetcdfFile::define(const std::string& name, int type, const std::vector<Dimension>& dimensions) {
  Variable variable{0, {}};
  std::vector<int> ids;
  for (const Dimension& d : dimensions) {
    ids.push_back(d.id);
    variable.shape.push_back(d.length);
  }
  check(nc_def_var(id_, name.c_str(), type, static_cast<int>(ids.size()), ids.data(), &variable.id));
  if (type != NC_STRING) check(nc_def_var_fill(id_, variable.id, NC_NOFILL, nullptr));
  return variable;
}

NetcdfFile::Variable NetcdfFile::doubles(const std::string& name, const std::vector<Dimension>& dimensions) {
  return define(name, NC_DOUBLE, dimensions);
}
NetcdfFile::Variable NetcdfFile::bytes(const std::string& name, const std::vector<Dimension>& dimensions) {
  return define(name, NC_BYTE, dimensions);
}
NetcdfFile::Variable NetcdfFile::integers(const std::string& name, const std::vector<Dimension>& dimensions) {
  return define(name, NC_INT, dimensions);
}
NetcdfFile::Variable NetcdfFile::strings(const std::string& name, const std::vector<Dimension>& dimensions) {
  return define(name, NC_STRING, dimensions);
}

void NetcdfFile::attribute(const Variable* variable, const std::string& name, const std::string& value) {
  check(nc_put_att_text(id_, id_of(variable), name.c_str(), value.size(), value.data()));
}
void NetcdfFile::attribute(const Variable* variable, const std::string& name, double value) {
  check(nc_put_att_double(id_, id_of(variable), name.c_str(), NC_DOUBLE, 1, &value));
}
void NetcdfFile::attribute(const Variable* variable, const std::string& name, std::int64_t value) {
  const long long wide = value;
  check(nc_put_att_longlong(id_, id_of(variable), name.c_str(), NC_INT64, 1, &wide));
}
void NetcdfFile::attribute(const Variable& variable, const std::string& name, const std::vector<signed char>& values) {
  check(nc_put_att_schar(id_, variable.id, name.c_str(), NC_BYTE, values.size(), values.data()));
}
void NetcdfFile::fill_value(const Variable& variable, signed char value) { attribute(variable, "_FillValue", {value}); }
void NetcdfFile::fill_value(const Variable& variable, int value) {
  check(nc_put_att_int(id_, variable.id, "_FillValue", NC_INT, 1, &value));
}

void NetcdfFile::put(const Variable& variable, std::size_t first, std::span<const double> values) {
  put_run(variable, first, values, [&](const auto* start, const auto* count, const double* data) {
    check(nc_put_vara_double(id_, variable.id, start, count, data));
  });
}
void NetcdfFile::put(const Variable& variable, std::size_t first, std::span<const signed char> values) {
  put_run(variable, first, values, [&](const auto* start, const auto* count, const signed char* data) {
    check(nc_put_vara_schar(id_, variable.id, start, count, data));
  });
}
void NetcdfFile::put(const Variable& variable, std::size_t first, std::span<const int> values) {
  put_run(variable, first, values, [&](const auto* start, const auto* count, const int* data) {
    check(nc_put_vara_int(id_, variable.id, start, count, data));
  });
}
void NetcdfFile::put(const Variable& variable, const std::vector<std::string>& values) {
  std::vector<const char*> texts;
  texts.reserve(values.size());
  for (const std::string& value : values) texts.push_back(value.c_str());
  check(nc_put_var_string(id_, variable.id, texts.data()));
}

void NetcdfFile::close() {
  const int id = id_;
  id_ = -1;
  check(nc_close(id));
  const int file = open(path_.c_str(), O_RDONLY | O_CLOEXEC);  // NOLINT: its C signature
  const bool synced = file >= 0 && fsync(file) == 0;
  if (file >= 0) ::close(file);
  if (!synced) throw ComputationFailed("cannot write " + path_.string() + ": is the disk full?");
}

}  // namespace turgor
