// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <vector>

#include "silt/experiments/comparison_table.h"

namespace silt::experiments {
namespace {

// UTF-8 characters other than continuation bytes.
std::size_t Width(const std::string& text) {
  return std::size_t(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string Right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, Width(text)), ' ') + text;
}

std::string Left(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, Width(text)), ' ');
}

}  // namespace

std::string FormatText(const ComparisonTable& table) {
  constexpr std::size_t kLabel = 20, kGap = 3;
  std::vector<std::size_t> widths;
  for (const std::string& column : table.columns)
    widths.push_back(std::max<std::size_t>(6, column.size()));
  std::size_t group_width = widths.size() - 1;
  for (const std::size_t width : widths) group_width += width;

  std::string text = table.title + "\n" + std::string(kLabel, ' ');
  for (const std::string& group : table.groups) {
    text += std::string(kGap, ' ') + Right(group, group_width);
  }
  text += "\n" + std::string(kLabel, ' ');
  const auto add_cells = [&](const std::vector<std::string>& cells) {
    text += std::string(kGap - 1, ' ');
    for (std::size_t i = 0; i < cells.size(); ++i) text += " " + Right(cells[i], widths[i]);
  };
  for (std::size_t g = 0; g < table.groups.size(); ++g) add_cells(table.columns);
  text += "\n";
  for (const ComparisonTable::Row& row : table.rows) {
    text += Left(row.label, kLabel);
    for (const auto& cells : row.cells) add_cells(cells);
    text += "\n";
  }
  return text;
}

std::string EscapeHtml(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    safe += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  }
  return safe;
}

std::string FormatHtml(const ComparisonTable& table) {
  std::string html =
      "<table><caption>" + EscapeHtml(table.title) + "</caption><thead><tr><th></th>";
  for (const std::string& group : table.groups) {
    html += "<th class=\"group\" colspan=\"" + std::to_string(table.columns.size()) + "\">" +
            EscapeHtml(group) + "</th>";
  }
  html += "</tr><tr><th></th>";
  const auto add_cells = [&](const std::vector<std::string>& cells, const char* tag) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      html += std::string("<") + tag + (i == 0 ? " class=\"paper\">" : ">") + EscapeHtml(cells[i]) +
              "</" + tag + ">";
    }
  };
  for (std::size_t g = 0; g < table.groups.size(); ++g) add_cells(table.columns, "th");
  html += "</tr></thead><tbody>";
  for (const ComparisonTable::Row& row : table.rows) {
    html += "<tr><th>" + EscapeHtml(row.label) + "</th>";
    for (const auto& cells : row.cells) add_cells(cells, "td");
    html += "</tr>";
  }
  return html + "</tbody></table>\n";
}

}  // namespace silt::experiments
