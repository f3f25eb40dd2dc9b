// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "silt/dense/align_bench.h"
#include "silt/dense/backends.h"
#include "silt/dense/json_text.h"

// Speeds of alignments beside what must be read and computed at least, and beside what the device
// reaches.
namespace silt::dense {

// How long the floor takes at the device's ceilings, in milliseconds: what is slower of reading and
// computing. 0 where the ceilings are not known.
double FloorMilliseconds(const Work& work, const Ceilings& ceilings);

// What is not known is null.
JsonText FiguresJson(const AlignFigures& figures, const Ceilings& ceilings);
// For a person.
std::string FiguresText(const std::string& name, const AlignFigures& figures,
                        const Ceilings& ceilings);

}  // namespace silt::dense
