// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

namespace silt::tracker {

// What a residual counts, see kernel/robust_norm.h.
enum class RobustLoss { kGemanMcClure, kHuber, kTukey, kStudentT };

}  // namespace silt::tracker
