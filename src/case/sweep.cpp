#include "turgor/case/sweep.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "parts.hpp"
#include "turgor/base/text.hpp"
#include "turgor/case/quantities.hpp"

namespace turgor {

namespace {
constexpr std::array<Sampler, 3> samplers{Sampler::grid, Sampler::latin_hypercube, Sampler::sobol};
constexpr double most_events = 1000;
}  // namespace

std::string_view name_of(Sampler sampler) {
  switch (sampler) {
    case Sampler::grid: return "grid";
    case Sampler::latin_hypercube: return "latin-hypercube";
    case Sampler::sobol: return "sobol";
  }
  return "";
}

std::uint64_t Axis::count() const {
  if (const auto* list = std::get_if<AxisValues>(&form)) return list->values.size();
  const auto* range = std::get_if<AxisRange>(&form);
  return range != nullptr ? range->count : 0;
}

void declare_sweep(Schema& schema) {
  using enum ValueKind;
  schema.describe("sweep", "a parameter study, for `turgor sweep`; other commands check it and leave it at that");
  std::vector<std::string> sampler_names;
  std::vector<std::string> quantities;
  sampler_names.reserve(samplers.size());
  quantities.reserve(quantity_names().size());
  for (const Sampler sampler : samplers) sampler_names.emplace_back(name_of(sampler));
  for (const auto& quantity : quantity_names()) quantities.emplace_back(quantity.name);
  schema.add({.path = "sweep.sampler",
              .kind = text,
              .choices = sampler_names,
              .fallback = "grid",
              .meaning = "every combination of values, or samples of distributions"});
  schema.add({.path = "sweep.members",
              .kind = integer,
              .range = {1, static_cast<double>(most_members)},
              .meaning = "number of samples; a grid has the product of its axes instead"});
  schema.add({.path = "sweep.seed",
              .kind = integer,
              .range = {0, 9e15},
              .fallback = "0",
              .meaning = "of the samples; 0 with sobol: the sequence as it is, otherwise shifted digitally"});
  schema.add({.path = "sweep.quantities",
              .kind = text_list,
              .choices = quantities,
              .meaning = "quantities of interest to keep; all when not given"});
  schema.add({.path = "sweep.event_times",
              .kind = integer,
              .range = {0, most_events},
              .fallback = "0",
              .meaning = "keep the times and stretches of so many first regime changes"});
  schema.add({.path = "sweep.axes",
              .kind = free_table,
              .meaning = "\"table.key\" = { from, to, n, spacing = \"linear\" | \"log\" } or { values = [...] } in a "
                         "grid; { from, to, spacing }, { uniform = [a, b] }, { normal = [mean, sigma] } or "
                         "{ lognormal = [median, sigma of ln x] } when sampled"});
}

namespace {

/// Reads the axes of one case.
class AxisReader {
 public:
  AxisReader(Reader& reader, Sampler sampler) : reader_(reader), sampled_(sampler != Sampler::grid) {}

  std::vector<Axis> all() {
    const Node* table = reader_.node("sweep.axes");
    if (table != nullptr && table->as<Node::Table>() == nullptr) return {};  // said by check_unknown
    if (table == nullptr || table->as<Node::Table>()->empty()) {
      reader_.complain("sweep.axes", "no axes",
                       R"(write for example "inlet.orifice_radius" = { from = "1 cm", to = "3 cm", n = 100 })");
      return {};
    }
    Node places = reader_.root();  // to find out where a key leads
    for (const auto& entry : *table->as<Node::Table>()) read(entry.key, entry.node, places);
    return std::move(axes_);
  }

 private:
  /// A key whose values can be swept; an element of a list counts as a value of that list's kind.
  std::optional<Key> swept_key(const std::string& name) {
    const std::string top = name.substr(0, name.find('.'));
    if (name == "title" || top == "sweep" || top == "output" || top == "expect" || top == "fem" || top == "wall") {
      reader_.complain(path_, "cannot be swept", "keys of the balloon, its pressure and its motion can");
      return std::nullopt;
    }
    const Key* found = reader_.find_key(name);
    bool element = false;
    if (found == nullptr && name.ends_with(']')) {
      found = reader_.find_key(name.substr(0, name.rfind('[')));
      element = found != nullptr && (found->kind == ValueKind::quantity_list || found->kind == ValueKind::number_list);
      if (!element) found = nullptr;
    }
    if (found == nullptr) {
      const std::string near = reader_.nearest(name);
      const bool unquoted = name.find('.') == std::string::npos;
      std::string advice = near.empty() ? "" : "did you mean \"" + near + "\"?";
      if (unquoted) advice = "write the whole key in quotes, such as \"inlet.orifice_radius\"";
      reader_.complain(path_, "no such key in a case", advice);
      return std::nullopt;
    }
    Key key = *found;
    if (element) key.kind = key.kind == ValueKind::quantity_list ? ValueKind::quantity : ValueKind::number;
    using enum ValueKind;
    if (key.kind != quantity && key.kind != number && key.kind != integer && key.kind != text) {
      reader_.complain(path_, "cannot be swept", "only numbers, quantities and words can");
      return std::nullopt;
    }
    return key;
  }

  /// Complains about a key that leads nowhere, or to where another axis leads.
  bool has_own_place(const std::string& name, Node& places) {
    try {
      const Node* place = &place_value(places, name);
      for (const Axis& other : axes_) {
        if (&place_value(places, other.key) != place) continue;
        reader_.complain(path_, "the same axis twice", "it is also called \"" + other.key + "\"");
        return false;
      }
      return true;
    } catch (const InvalidInput& error) {
      reader_.complain(path_, error.issues().front().problem, "an axis changes a value of the case");
      return false;
    }
  }

  void read(const std::string& name, const Node& node, Node& places) {
    path_ = "sweep.axes.\"" + name + "\"";
    const auto key = swept_key(name);
    if (!key || !has_own_place(name, places)) return;
    if (node.as<Node::Table>() == nullptr) {
      reader_.complain(path_, "is " + std::string(node.type_name()) + ", not a table", forms());
      return;
    }
    Axis axis{name, key->kind == ValueKind::text ? "" : key->unit, AxisValues{}};
    if (read_form(*key, *node.as<Node::Table>(), axis)) axes_.push_back(std::move(axis));
  }

  [[nodiscard]] std::string forms() const {
    return sampled_ ? "write { from = ..., to = ... }, { uniform = [a, b] }, { normal = [mean, sigma] } or "
                      "{ lognormal = [median, sigma] }"
                    : "write { from = ..., to = ..., n = 100 } or { values = [...] }";
  }

  bool read_form(const Key& key, const Node::Table& table, Axis& axis) {
    static constexpr std::array<std::string_view, 4> range_words{"from", "to", "n", "spacing"};
    static constexpr std::array<std::string_view, 4> list_words{"values", "uniform", "normal", "lognormal"};
    std::vector<std::string> lists;
    bool range = false;
    for (const auto& entry : table) {
      const bool of_range = std::ranges::find(range_words, entry.key) != range_words.end();
      range = range || of_range;
      if (of_range) continue;
      if (std::ranges::find(list_words, entry.key) == list_words.end()) {
        reader_.complain(path_ + "." + entry.key, "unknown key", forms());
        return false;
      }
      lists.push_back(entry.key);
    }
    if (lists.size() + (range ? 1U : 0U) != 1) {
      reader_.complain(path_, lists.empty() ? "has no values" : "says more than one thing", forms());
      return false;
    }
    if (range) return read_range(key, axis);
    if ((lists.front() == "values") == sampled_) {
      reader_.complain(path_ + "." + lists.front(),
                       sampled_ ? "a list of values is for grids" : "a distribution is for samplers other than grid",
                       forms());
      return false;
    }
    return lists.front() == "values" ? read_values(key, axis) : read_distribution(key, lists.front(), axis);
  }

  bool is_real(const Key& key) {
    if (key.kind == ValueKind::quantity || key.kind == ValueKind::number) return true;
    reader_.complain(path_, key.kind == ValueKind::text ? "takes words" : "takes whole numbers",
                     sampled_ ? "it can be swept by { values = [...] } in a grid" : "write { values = [...] }");
    return false;
  }

  bool read_range(const Key& key, Axis& axis) {
    if (!is_real(key)) return false;
    const auto from = reader_.number_like(path_ + ".from", key);
    const auto to = reader_.number_like(path_ + ".to", key);
    const auto count = read_count();
    const Node* spacing = reader_.node(path_ + ".spacing");
    const auto* word = spacing != nullptr ? spacing->as<std::string>() : nullptr;
    if (spacing != nullptr && (word == nullptr || (*word != "linear" && *word != "log"))) {
      reader_.complain(path_ + ".spacing", "unknown name", R"(one of "linear", "log")");
      return false;
    }
    const bool logarithmic = word != nullptr && *word == "log";
    if (!from || !to || !count) return false;
    if (logarithmic && (*from <= 0 || *to <= 0)) {
      reader_.complain(path_ + (*from > 0 ? ".to" : ".from"), "must be > 0 with spacing = \"log\"",
                       "use spacing = \"linear\" across zero");
      return false;
    }
    if (*from == *to && *count != 1) {
      reader_.complain(path_, "from and to are the same", sampled_ ? "" : "give n = 1 for a single value");
      return false;
    }
    axis.form = AxisRange{*from, *to, logarithmic, *count};
    return true;
  }

  /// How many values a grid has; 0 when sampled.
  std::optional<std::uint64_t> read_count() {
    const std::string path = path_ + ".n";
    const Node* given = reader_.node(path);
    if (sampled_) {
      if (given == nullptr) return 0;
      reader_.complain(path, "goes with sampler = \"grid\"", "sweep.members is the number of samples");
      return std::nullopt;
    }
    const auto* n = given != nullptr ? given->as<std::int64_t>() : nullptr;
    if (n == nullptr) {
      reader_.complain(path,
                       given == nullptr ? "missing" : "is " + std::string(given->type_name()) + ", not an integer",
                       "give the number of values");
      return std::nullopt;
    }
    if (*n < 1 || static_cast<std::uint64_t>(*n) > most_members) {
      reader_.complain(path, "out of range", "allowed is from 1 to 1e+09");
      return std::nullopt;
    }
    return static_cast<std::uint64_t>(*n);
  }

  /// The elements of a list in this axis; nothing when there is no list or it has the wrong length.
  const Node::Array* list(const std::string& path, std::size_t length) {
    const Node* node = reader_.node(path);
    const auto* items = node->as<Node::Array>();
    if (items == nullptr) {
      reader_.complain(path, "is " + std::string(node->type_name()) + ", not a list", forms());
    } else if (length > 0 ? items->size() != length : items->empty()) {
      reader_.complain(path, length > 0 ? "has " + std::to_string(items->size()) + " elements, not 2" : "is empty",
                       forms());
      return nullptr;
    }
    return items;
  }

  bool read_values(const Key& key, Axis& axis) {
    const std::string path = path_ + ".values";
    const Node::Array* items = list(path, 0);
    if (items == nullptr) return false;
    AxisValues form;
    for (std::size_t i = 0; i < items->size(); ++i) {
      auto value = read_value(key, path + "[" + std::to_string(i) + "]", (*items)[i]);
      if (value) form.values.push_back(std::move(*value));
    }
    const bool complete = form.values.size() == items->size();
    axis.form = std::move(form);
    return complete;
  }

  std::optional<Node> read_value(const Key& key, const std::string& path, const Node& given) {
    const auto* word = given.as<std::string>();
    const bool known = word != nullptr && std::ranges::find(key.choices, *word) != key.choices.end();
    if (key.kind == ValueKind::text) {
      if (word != nullptr && (known || key.choices.empty())) return Node{*word, "", 0};
      std::string names;
      for (const auto& choice : key.choices) names += (names.empty() ? "one of \"" : ", \"") + choice + "\"";
      reader_.complain(path, word == nullptr ? "is not a string" : "unknown name", names);
      return std::nullopt;
    }
    if (known) return Node{*word, "", 0};
    if (key.kind == ValueKind::integer && given.as<std::int64_t>() == nullptr) {
      reader_.complain(path, "is " + std::string(given.type_name()) + ", not an integer");
      return std::nullopt;
    }
    const auto value = reader_.number_like(path, key);
    if (!value) return std::nullopt;
    if (key.kind == ValueKind::integer) return Node{static_cast<std::int64_t>(*value), "", 0};
    if (key.kind == ValueKind::number) return Node{*value, "", 0};
    return Node{Node::Quantity{*value, key.unit}, "", 0};
  }

  bool read_distribution(const Key& key, const std::string& name, Axis& axis) {
    if (!is_real(key)) return false;
    const std::string path = path_ + "." + name;
    if (list(path, 2) == nullptr) return false;
    Key sigma_key = key;
    sigma_key.range = name == "uniform" ? key.range : positive;
    if (name == "lognormal") sigma_key.kind = ValueKind::number;
    if (name == "lognormal") sigma_key.unit = "1";
    Key first_key = key;
    if (name == "lognormal") first_key.range = positive;
    const auto first = reader_.number_like(path + "[0]", first_key);
    const auto second = reader_.number_like(path + "[1]", sigma_key);
    if (!first || !second) return false;
    if (name == "normal") {
      axis.form = NormalAxis{*first, *second};
    } else if (name == "lognormal") {
      axis.form = LognormalAxis{*first, *second};
    } else {
      if (*first == *second) reader_.complain(path, "both ends are the same");
      axis.form = AxisRange{*first, *second, false, 0};
    }
    return true;
  }

  Reader& reader_;
  bool sampled_;
  std::string path_;
  std::vector<Axis> axes_;
};

std::string toml_of(const Axis& axis) {
  const auto quantity = [&](double value) { return toml_quantity(value, axis.unit); };
  std::string out = toml_string(axis.key) + " = { ";
  if (const auto* range = std::get_if<AxisRange>(&axis.form)) {
    out += "from = " + quantity(range->from) + ", to = " + quantity(range->to);
    if (range->count > 0) out += ", n = " + std::to_string(range->count);
    out += ", spacing = \"" + std::string(range->logarithmic ? "log" : "linear") + "\"";
  } else if (const auto* list = std::get_if<AxisValues>(&axis.form)) {
    std::string items;
    for (const Node& node : list->values) {
      items += items.empty() ? "" : ", ";
      if (const auto* exact = node.as<Node::Quantity>()) {
        items += toml_quantity(exact->value, exact->unit);
      } else if (const auto* number = node.as<double>()) {
        items += toml_quantity(*number, "1");
      } else if (const auto* integer = node.as<std::int64_t>()) {
        items += std::to_string(*integer);
      } else {
        items += toml_string(*node.as<std::string>());
      }
    }
    out += "values = [" + items + "]";
  } else if (const auto* normal = std::get_if<NormalAxis>(&axis.form)) {
    out += "normal = [" + quantity(normal->mean) + ", " + quantity(normal->sigma) + "]";
  } else if (const auto* lognormal = std::get_if<LognormalAxis>(&axis.form)) {
    out += "lognormal = [" + quantity(lognormal->median) + ", " + toml_quantity(lognormal->sigma, "1") + "]";
  }
  return out + " }";
}

/// The number of members; 0 after a complaint.
std::uint64_t count_members(Reader& reader, const SweepSettings& s) {
  const auto given = reader.integer("sweep.members");
  const bool is_given = reader.node("sweep.members") != nullptr;
  if (s.sampler != Sampler::grid) {
    if (!is_given) reader.complain("sweep.members", "missing", "give the number of samples, such as members = 10000");
    return given ? static_cast<std::uint64_t>(*given) : 0;
  }
  if (is_given) {
    reader.complain("sweep.members", "goes with samplers other than grid", "a grid has the product of its axes' n");
    return 0;
  }
  double product = 1;
  for (const Axis& axis : s.axes) product *= static_cast<double>(axis.count());
  if (product > static_cast<double>(most_members)) {
    reader.complain("sweep.axes", "this grid has " + rounded(product, 6) + " members",
                    "at most 1e+09 are allowed: reduce n, or sample with sampler = \"sobol\"");
    return 0;
  }
  return static_cast<std::uint64_t>(product);
}

}  // namespace

void read_sweep(Reader& reader, Case& c) {
  const Node* given = reader.node("sweep");
  if (given == nullptr || given->as<Node::Table>() == nullptr) return;  // the latter said by check_unknown
  SweepSettings s;
  const auto sampler = reader.text("sweep.sampler");
  for (const Sampler candidate : samplers) {
    if (sampler == name_of(candidate)) s.sampler = candidate;
  }
  s.seed = static_cast<std::uint64_t>(reader.integer("sweep.seed").value_or(0));
  s.event_times = static_cast<std::uint64_t>(reader.integer("sweep.event_times").value_or(0));
  const auto asked = reader.texts("sweep.quantities");
  if (asked && asked->empty() && reader.node("sweep.quantities")->as<Node::Array>()->empty()) {
    reader.complain("sweep.quantities", "is empty", "leave it out to keep all");
  }
  for (const auto& quantity : quantity_names()) {
    if (!asked || std::ranges::find(*asked, quantity.name) != asked->end()) s.quantities.emplace_back(quantity.name);
  }
  s.axes = AxisReader(reader, s.sampler).all();
  s.members = count_members(reader, s);
  if (s.seed != 0 && s.sampler == Sampler::grid) reader.complain("sweep.seed", "goes with samplers other than grid");
  reader.resolve("sweep.axes", [&] {
    std::string toml;
    for (const Axis& axis : s.axes) toml += (toml.empty() ? "{ " : ", ") + toml_of(axis);
    return toml + " }";
  });
  c.sweep = std::move(s);
}

}  // namespace turgor
