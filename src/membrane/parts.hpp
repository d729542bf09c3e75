#pragma once
// What a Membrane keeps.

#include <array>
#include <utility>
#include <vector>

#include "element.hpp"
#include "turgor/membrane/membrane.hpp"

namespace turgor {

/// Where neighbouring elements meet, or the clamped rim, where one side is missing.
struct Joint {
  std::size_t node;                               ///< in the chain
  std::array<bool, 2> side;                       ///< whether there is an element before and behind it
  std::array<ReferencePoint, 2> reference;        ///< at the end of the element before, at the start of that behind
  std::array<std::array<double, 2>, 2> tangents;  ///< stress-free x' of both; of a missing side its neighbour's
  double kink;                                    ///< of the stress-free chain
  double size;                                    ///< harmonic mean of the elements' lengths [m]
};

/// Those of an element's nodes, or their velocities, from those of all nodes.
[[nodiscard]] inline Eigen::Matrix<double, element_unknowns, 1> places_of(const Eigen::VectorXd& all, std::size_t e) {
  return all.segment<element_unknowns>(static_cast<Eigen::Index>(4 * e));
}

struct Membrane::Parts {
  MembraneWall wall;
  Eigen::VectorXd reference;
  bool closed = false;
  double rim_radius = 0;
  double orientation = 1;  ///< +1 from the rim upwards and to the axis, with the liquid to the left
  std::vector<Eigen::Index> free;
  std::array<LineShape, 3> shapes;
  std::array<PointMap, 3> maps;
  std::vector<std::array<ReferencePoint, 3>> points;  ///< of each element at the Gauss points
  std::vector<Joint> joints;
  Eigen::SparseMatrix<double> mass;

  [[nodiscard]] std::size_t elements() const { return points.size(); }
  void set_points();
  void set_joints();
  void set_free(std::size_t rim_node);
  void set_mass();
};

/// Adds up a MembraneForm.
class FormSum {
 public:
  explicit FormSum(Eigen::Index unknowns) : form_{0, Eigen::VectorXd::Zero(unknowns), {unknowns, unknowns}} {}

  /// Adds factor times a function of m variables, which are map times the places from unknown `first` on.
  template <int M, int N>
  void add(Eigen::Index first, const Eigen::Matrix<double, M, N>& map, const SecondOrder<M>& f, double factor) {
    form_.value += factor * f.value;
    form_.gradient.segment<N>(first) += factor * (map.transpose() * f.gradient);
    const Eigen::Matrix<double, N, N> hessian = factor * (map.transpose() * f.hessian * map);
    add_matrix(entries_, first, hessian);
  }

  template <int N>
  static void add_matrix(std::vector<Eigen::Triplet<double>>& entries, Eigen::Index first,
                         const Eigen::Matrix<double, N, N>& matrix) {
    for (Eigen::Index i = 0; i < N; ++i) {
      for (Eigen::Index j = 0; j < N; ++j) {
        entries.emplace_back(static_cast<int>(first + i), static_cast<int>(first + j), matrix(i, j));
      }
    }
  }

  [[nodiscard]] MembraneForm finish() {
    form_.hessian.setFromTriplets(entries_.begin(), entries_.end());
    return std::move(form_);
  }

 private:
  MembraneForm form_;
  std::vector<Eigen::Triplet<double>> entries_;
};

/// The meridian at a point, as variables of its own.
[[nodiscard]] inline LinePoint<SecondOrder<point_variables>> variables_at(
    const Eigen::Matrix<double, point_variables, 1>& q) {
  using V = SecondOrder<point_variables>;
  return {V::variable(q(0), 0), V::variable(q(1), 1), V::variable(q(2), 2), V::variable(q(3), 3), V::variable(q(4), 4)};
}

/// Refuses a place that no membrane can take.
/// @throws ComputationFailed
void require_regular(const Eigen::Matrix<double, point_variables, 1>& q, std::size_t element);

/// Strain energy at a point of an element.
/// @throws ComputationFailed when the material has locked
[[nodiscard]] BiaxialJet<double> checked_energy(const Material<double>& material, double l1, double l2, double radius);

/// Adds the penalised angles between elements to the elastic energy.
void add_joints(const MembraneWall& wall, const std::vector<Joint>& joints, const Eigen::VectorXd& places,
                FormSum& sum);

}  // namespace turgor
