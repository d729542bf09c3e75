#pragma once
// [material], which [balloon] reads and declares.

#include "turgor/case/case.hpp"
#include "turgor/case/reader.hpp"

namespace turgor {

void declare_material(Schema& schema);
void read_material(Reader& reader, Case& c);

}  // namespace turgor
