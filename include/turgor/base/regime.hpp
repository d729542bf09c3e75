#pragma once

namespace turgor {

/// What the balloon is doing; the value is s, the sign of dR/dT.
enum class Regime : int {
  deflating = -1,  ///< potential flow towards the orifice
  rest = 0,        ///< in equilibrium under a constant pressure
  inflating = 1,   ///< a jet into the balloon
};

}  // namespace turgor
