#include "segments.hpp"

namespace turgor {

void declare_segments(Schema& schema, const SegmentKeys& keys) {
  using enum ValueKind;
  const std::string item = keys.list + "[].";
  schema.add({.path = keys.start,
              .unit = keys.unit,
              .meaning = keys.quantity + " at t = 0 of a list of segments; 0 " + keys.unit + " when not given"});
  schema.add({.path = keys.list,
              .kind = table_list,
              .meaning = "segments one after the other from t = 0; the last value holds to t_end"});
  schema.add(
      {.path = item + "hold", .unit = "s", .range = positive, .meaning = "keep the " + keys.quantity + " this long"});
  if (keys.steps) schema.add({.path = item + "step", .unit = keys.unit, .meaning = "jump to this " + keys.quantity});
  schema.add({.path = item + "to", .unit = keys.unit, .meaning = "go to this " + keys.quantity + ", over `over`"});
  schema.add({.path = item + "over", .unit = "s", .range = positive, .meaning = "duration of `to`"});
  schema.add({.path = item + "shape",
              .kind = text,
              .choices = {"linear", "smooth"},
              .fallback = "linear",
              .meaning = "of `to`: a straight line, or x^3 (10 - 15 x + 6 x^2)"});
}

namespace {

/// Reads one list; what it appends it also writes as TOML.
class SegmentReader {
 public:
  SegmentReader(Reader& reader, const SegmentKeys& keys)
      : reader_(reader), keys_(keys), list_(reader.number(keys.start).value_or(0)) {}

  /// One segment; nothing is appended when something is wrong with it.
  void read(const std::string& path) {
    if (!has_one_kind(path)) return;
    if (given(path, "hold")) {
      if (const auto duration = reader_.number(path + ".hold")) {
        list_.hold(*duration);
        write("hold = " + toml_quantity(*duration, "s"));
      }
    } else if (given(path, "step")) {
      if (const auto value = reader_.number(path + ".step")) {
        list_.step(*value);
        write("step = " + toml_quantity(*value, keys_.unit));
      }
    } else {
      read_ramp(path);
    }
    if (given(path, "to")) return;
    for (const char* extra : {"over", "shape"}) {
      if (given(path, extra)) reader_.complain(path + "." + extra, "goes with `to` only", forms());
    }
  }

  [[nodiscard]] const SegmentList<double>& list() const { return list_; }
  [[nodiscard]] std::string toml() const { return "[" + toml_ + "]"; }

 private:
  [[nodiscard]] bool given(const std::string& path, const char* key) const {
    return reader_.node(path + "." + key) != nullptr;
  }

  [[nodiscard]] std::string forms() const {
    const std::string step = keys_.steps ? ", { step = \"" + keys_.example + "\" }" : "";
    return "write { hold = \"2 s\" }" + step + " or { to = \"" + keys_.example + "\", over = \"2 s\" }";
  }

  bool has_one_kind(const std::string& path) {
    if (!keys_.steps && given(path, "step")) {
      reader_.complain(path, "a jump of the " + keys_.quantity + " would take an infinite acceleration", forms());
      return false;
    }
    const int kinds = (given(path, "hold") ? 1 : 0) + (given(path, "step") ? 1 : 0) + (given(path, "to") ? 1 : 0);
    if (kinds == 1) return true;
    const std::string problem = kinds == 0 ? "says neither " : "says more than one of ";
    const std::string joint = kinds == 0 ? " nor to" : " and to";
    reader_.complain(path, problem + (keys_.steps ? "hold, step" : "hold") + joint, forms());
    return false;
  }

  void read_ramp(const std::string& path) {
    if (!given(path, "over")) reader_.complain(path, "says to but not over", forms());
    const auto value = reader_.number(path + ".to");
    const auto duration = reader_.number(path + ".over");
    const auto shape = reader_.text(path + ".shape");
    if (!value || !duration || !shape) return;
    list_.ramp(*value, *duration, *shape == "smooth" ? RampShape::smooth : RampShape::linear);
    write("to = " + toml_quantity(*value, keys_.unit) + ", over = " + toml_quantity(*duration, "s") +
          ", shape = " + toml_string(*shape));
  }

  void write(const std::string& segment) { toml_ += (toml_.empty() ? "{ " : ", { ") + segment + " }"; }

  Reader& reader_;
  const SegmentKeys& keys_;
  SegmentList<double> list_;
  std::string toml_;
};

}  // namespace

std::optional<SegmentList<double>> read_segments(Reader& reader, const SegmentKeys& keys) {
  const Node* given = reader.node(keys.list);
  if (given == nullptr) {
    reader.complain(keys.list, "missing", "give at least one segment, such as { hold = \"2 s\" }");
    return std::nullopt;
  }
  const auto* items = given->as<Node::Array>();
  if (items == nullptr) return std::nullopt;  // said by check_unknown
  if (items->empty()) {
    reader.complain(keys.list, "is empty", "give at least one segment, such as { hold = \"2 s\" }");
    return std::nullopt;
  }
  SegmentReader segments(reader, keys);
  for (std::size_t i = 0; i < items->size(); ++i) {
    if ((*items)[i].as<Node::Table>() != nullptr) segments.read(keys.list + "[" + std::to_string(i) + "]");
  }
  reader.resolve(keys.list, [&] { return segments.toml(); });
  return segments.list();
}

}  // namespace turgor
