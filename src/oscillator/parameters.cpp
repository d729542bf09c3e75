#include "turgor/oscillator/parameters.hpp"

#include "turgor/base/errors.hpp"
#include "turgor/base/text.hpp"
#include "turgor/oscillator/oscillator.hpp"

namespace turgor {

namespace {

template <class T>
bool has_closure_at(const Parameters<T>& p, const T& stretch) {
  const T kappa = kappa_at(p, stretch);
  return kappa >= T(ForceTable::least_kappa) && kappa <= T(ForceTable::greatest_kappa);
}

}  // namespace

template <class T>
const ForceTable* force_table(const Parameters<T>& p) {
  const ForceTable* table = force_table(p.closure, p.channel_length > 0, p.outflow.get());
  if (table == nullptr) return nullptr;
  if (has_closure_at(p, T(1))) return table;
  const auto times_radius = [&](double share) { return rounded(share * static_cast<double>(p.radius), 6) + " m"; };
  throw InvalidInput("inlet.orifice_radius", shortest(static_cast<double>(p.orifice_radius)) + " m",
                     "beyond the range of model.closure = \"" + std::string(name_of(p.closure)) + "\"",
                     "must be from " + times_radius(ForceTable::least_kappa) + " to " +
                         times_radius(ForceTable::greatest_kappa) + ", 2^-17 to 0.75 of balloon.radius");
}

template <class T>
void require_closure(const Parameters<T>& p, const T& stretch) {
  if (!has_table(p.closure) || has_closure_at(p, stretch)) return;
  const StretchLimits<T> limits = closure_limits(p);
  const auto number = [](const T& x) { return rounded(static_cast<double>(x), 8); };
  throw InvalidInput("initial.stretch", shortest(static_cast<double>(stretch)),
                     "beyond the range of model.closure = \"" + std::string(name_of(p.closure)) + "\"",
                     "must be from " + number(limits.least) + " to " + number(limits.greatest) +
                         ", where inlet.orifice_radius is 0.75 to 2^-17 of the balloon's radius");
}

template const ForceTable* force_table(const Parameters<double>&);
template const ForceTable* force_table(const Parameters<long double>&);
template void require_closure(const Parameters<double>&, const double&);
template void require_closure(const Parameters<long double>&, const long double&);

}  // namespace turgor
