// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "silt/core/io/sequence_writer.h"
#include "silt/core/recorded_sequence.h"

// The layouts of sequences by name.
namespace silt {

// tum icl euroc nerfstudio colmap raw: all can be written.
const std::vector<std::string>& SequenceFormats();
// tum icl euroc raw: can be read too.
const std::vector<std::string>& ReadableFormats();

// Throws silt::Error for an unknown format, and for a sequence that the format cannot hold.
std::unique_ptr<SequenceWriter> MakeSequenceWriter(const std::string& format,
                                                   const std::filesystem::path& folder,
                                                   const SequenceDescription& description);

struct ReadingOptions {
  PinholeCamera camera;  // replaces that of a tum folder unless fx is 0
  int take_every = 1;    // 3 makes 20 fps of 60
  // Of a tum folder: how far apart in time the images of one frame may be; nothing: 0.02 s.
  std::optional<double> association_tolerance_s = std::nullopt;
};

// `format` is one that can be read, or auto, which looks what the folder holds. Throws silt::Error.
std::unique_ptr<RecordedSequence> OpenSequence(const std::string& format,
                                               const std::filesystem::path& folder,
                                               const ReadingOptions& options = {});

}  // namespace silt
