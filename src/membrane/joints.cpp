#include "parts.hpp"

namespace turgor {

namespace {

/// sigma: for quadratic elements the energy of a flat chain is positive from 1 on.
constexpr double penalty = 4;

/// Variables of a joint: r, then r', z', r'', z'' of the element before and of the one behind.
constexpr int joint_variables = 9;
constexpr int joint_unknowns = 10;
using V = SecondOrder<joint_variables>;
using JointMap = Eigen::Matrix<double, joint_variables, joint_unknowns>;

/// From the places of the five nodes of both elements to the variables.
JointMap joint_map() {
  const PointMap before = point_map(line_shape(1));
  const PointMap behind = point_map(line_shape(-1));
  JointMap map = JointMap::Zero();
  map.topLeftCorner<point_variables, element_unknowns>() = before;
  map.bottomRightCorner<4, element_unknowns>() = behind.bottomRows<4>();
  return map;
}

/// The energy of one joint per distance from the axis and radian. A missing side takes no part.
V joint_energy(const Joint& joint, const Eigen::Matrix<double, joint_variables, 1>& q, double stiffness) {
  const V r = V::variable(q(0), 0);
  std::array<V, 2> dr;
  std::array<V, 2> dz;
  V moment;
  V shrink;  // mean of the inverse stretch along the meridian
  const double share = joint.side[0] && joint.side[1] ? 0.5 : 1.0;
  for (std::size_t s = 0; s < 2; ++s) {
    if (!joint.side[s]) {
      dr[s].value = joint.tangents[s][0];
      dz[s].value = joint.tangents[s][1];
      continue;
    }
    const int first = s == 0 ? 1 : 5;
    dr[s] = V::variable(q(first), first);
    dz[s] = V::variable(q(first + 1), first + 1);
    const LinePoint<V> x{r, dr[s], dz[s], V::variable(q(first + 2), first + 2), V::variable(q(first + 3), first + 3)};
    const auto k = bending_strains(x, joint.reference[s]);
    moment = moment + (share * stiffness) * (k[0] + 0.5 * k[1]);
    const V length = x.length();
    const double inverse = 1 / length.value;
    const V over_length = chain(length, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
    shrink = shrink + (share * joint.reference[s].length) * over_length;
  }
  const V jump = shrink * kink(dr[0], dz[0], dr[1], dz[1]) - joint.kink;
  return moment * jump + (0.5 * penalty * stiffness / joint.size) * (jump * jump);
}

}  // namespace

void add_joints(const MembraneWall& wall, const std::vector<Joint>& joints, const Eigen::VectorXd& places,
                FormSum& sum) {
  const JointMap map = joint_map();
  for (const Joint& joint : joints) {
    const double radius = joint.reference[joint.side[0] ? 0 : 1].radius;
    if (joint.side[0] && joint.side[1]) {
      const auto first = static_cast<Eigen::Index>(2 * joint.node) - 4;
      const Eigen::Matrix<double, joint_variables, 1> q = map * places.segment<joint_unknowns>(first);
      sum.add(first, map, joint_energy(joint, q, wall.bending_stiffness), radius);
      continue;
    }
    // a clamped end: the element that is there has its unknowns at the end of the map, or at its start
    const bool behind = joint.side[1];
    const Eigen::Index first = static_cast<Eigen::Index>(2 * joint.node) - (behind ? 0 : 4);
    const Eigen::Matrix<double, joint_variables, element_unknowns> part =
        behind ? map.rightCols<element_unknowns>() : map.leftCols<element_unknowns>();
    const Eigen::Matrix<double, joint_variables, 1> q = part * places.segment<element_unknowns>(first);
    sum.add(first, part, joint_energy(joint, q, wall.bending_stiffness), radius);
  }
}

}  // namespace turgor
