// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "silt/core/random.h"

namespace silt::sim {

// Good text or bytes made bad: pieces removed, doubled, overwritten, and what parsers stumble over
// put between. Mutation `number` is the same in every run.
inline std::string Mutated(std::string text, std::uint64_t number) {
  static const std::vector<std::string> kStumblingBlocks{
      "nan",  "inf", "-1", "0",        "1e308", "-1e308", "99999999999999999999",
      "\"",   "[",   "]]", "{",        "}",     "=",      "\n",
      "\r\n", "#",   "\\", "\xff\xfe", "'",     ",,",     "..",
      "/",    "%s",  "\t", "true",     "1e-30"};
  const CounterRandom random(number, 77);
  std::uint64_t draw = 0;
  const auto below = [&](std::size_t n) { return n == 0 ? 0 : random.Bits(draw++) % n; };
  for (std::size_t rounds = 1 + below(3); rounds > 0; --rounds) {
    const std::size_t at = below(text.size() + 1);
    const std::size_t length = below(std::min<std::size_t>(24, text.size() - at) + 1);
    switch (below(5)) {
      case 0:
        text.erase(at, length);
        break;
      case 1:
        text.insert(at, text.substr(at, length));
        break;
      case 2:
        text.insert(below(text.size() + 1), text.substr(at, length));
        break;
      case 3:
        text.replace(at, length, kStumblingBlocks[below(kStumblingBlocks.size())]);
        break;
      default:
        if (at < text.size()) text[at] = char(random.Bits(draw++) & 0xff);
    }
  }
  return text;
}

}  // namespace silt::sim
