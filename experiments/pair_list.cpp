// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/experiments/pair_list.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "silt/core/error.h"

namespace silt::experiments {
namespace {

std::filesystem::path Found(const std::string& name, const std::filesystem::path& folder,
                            const std::string& where) {
  std::error_code ignored;
  const std::filesystem::path beside = folder / name;
  if (std::filesystem::is_regular_file(name, ignored)) return name;
  if (std::filesystem::is_regular_file(beside, ignored)) return beside;
  throw Error(where + "no file '" + name + "', neither here nor beside the list");
}

}  // namespace

std::vector<PairFiles> ReadPairList(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::vector<PairFiles> pairs;
  for (int number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line);
    const std::vector<std::string> names{std::istream_iterator<std::string>(words), {}};
    if (names.empty() || names.front().starts_with('#')) continue;
    const std::string where = file.string() + ":" + std::to_string(number) + ": ";
    if (names.size() != 3 && names.size() != 4) {
      throw Error(where + std::to_string(names.size()) +
                  " names; write ref_rgb ref_depth cur_rgb [cur_depth]");
    }
    const auto path = [&](std::size_t i) { return Found(names[i], file.parent_path(), where); };
    pairs.push_back(
        {path(0), path(1), path(2), names.size() == 4 ? path(3) : std::filesystem::path()});
  }
  if (in.bad() || pairs.empty()) throw Error(file.string() + ": not a readable list of pairs");
  return pairs;
}

}  // namespace silt::experiments
