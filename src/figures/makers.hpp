#pragma once
// The functions that make the figures, one or a few to a file.

#include "studio.hpp"

namespace turgor {

void make_flow_figure(Studio& studio);         // 2
void make_force_figure(Studio& studio);        // 3
void make_response_figure(Studio& studio);     // 4 and 6
void make_jet_figure(Studio& studio);          // 5
void make_statics_figure(Studio& studio);      // 7
void make_approach_figure(Studio& studio);     // 8
void make_portraits_figure(Studio& studio);    // 9
void make_decay_figure(Studio& studio);        // decay
void make_errors_figure(Studio& studio);       // errors
void make_bistability_figure(Studio& studio);  // bistability
void make_design_figure(Studio& studio);       // design

}  // namespace turgor
