// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string>

namespace silt {

// Whether Debian's python3 has numpy; tests that need it skip otherwise.
inline bool HasNumpy() {
  return std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") == 0;
}

// Runs a script with `folder` as its argument and numpy as np; false where an assertion fails.
inline bool Numpy(const std::string& script, const std::string& folder) {
  const std::string whole = "import sys, os, numpy as np\nos.chdir(sys.argv[1])\n" + script;
  return std::system(("/usr/bin/python3 - '" + folder + "' <<'END'\n" + whole + "\nEND").c_str()) ==
         0;
}

}  // namespace silt
