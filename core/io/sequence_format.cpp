// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "silt/core/io/sequence_format.h"

#include <algorithm>
#include <utility>

#include "silt/core/error.h"
#include "silt/core/io/colmap_sequence.h"
#include "silt/core/io/euroc_sequence.h"
#include "silt/core/io/euroc_sequence_writer.h"
#include "silt/core/io/icl_sequence.h"
#include "silt/core/io/nerfstudio_sequence.h"
#include "silt/core/io/raw_sequence_writer.h"
#include "silt/core/io/tum_sequence.h"
#include "silt/core/raw_sequence.h"

namespace silt {
namespace {

namespace fs = std::filesystem;

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

// Every n-th frame of another sequence.
class ThinnedSequence : public RecordedSequence {
 public:
  ThinnedSequence(std::unique_ptr<RecordedSequence> all, int take_every)
      : all_(std::move(all)), take_every_(take_every) {}

  const PinholeCamera& camera() const override { return all_->camera(); }
  int size() const override { return (all_->size() + take_every_ - 1) / take_every_; }
  std::optional<Frame> Next() override {
    std::optional<Frame> frame = all_->Next();
    for (int i = 1; frame && i < take_every_; ++i) {
      if (!all_->Next()) break;
    }
    return frame;
  }
  std::vector<double> times_s() const override {
    std::vector<double> times;
    const std::vector<double> all = all_->times_s();
    for (std::size_t i = 0; i < all.size(); i += std::size_t(take_every_)) times.push_back(all[i]);
    return times;
  }
  const Trajectory& truth() const override { return all_->truth(); }

 private:
  std::unique_ptr<RecordedSequence> all_;
  int take_every_;
};

std::string FormatOf(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw Error(folder.string() + ": no such sequence folder");
  if (fs::exists(folder / "frames.txt")) return "raw";
  if (fs::exists(folder / "mav0")) return "euroc";
  if (fs::exists(folder / "scene_00_0000.png")) return "icl";
  if (fs::exists(folder / "rgb.txt") || fs::exists(folder / "associations.txt")) return "tum";
  throw Error(folder.string() + ": holds no sequence that silt knows (" +
              Joined(ReadableFormats()) + ")");
}

}  // namespace

const std::vector<std::string>& SequenceFormats() {
  static const std::vector<std::string> formats{"tum",        "icl",    "euroc",
                                                "nerfstudio", "colmap", "raw"};
  return formats;
}

const std::vector<std::string>& ReadableFormats() {
  static const std::vector<std::string> formats{"tum", "icl", "euroc", "raw"};
  return formats;
}

std::unique_ptr<SequenceWriter> MakeSequenceWriter(const std::string& format,
                                                   const fs::path& folder,
                                                   const SequenceDescription& description) {
  if (format == "tum") return std::make_unique<TumSequenceWriter>(folder, description);
  if (format == "icl") return std::make_unique<IclSequenceWriter>(folder, description);
  if (format == "euroc") return std::make_unique<EurocSequenceWriter>(folder, description);
  if (format == "nerfstudio") {
    return std::make_unique<NerfstudioSequenceWriter>(folder, description);
  }
  if (format == "colmap") return std::make_unique<ColmapSequenceWriter>(folder, description);
  if (format == "raw") return std::make_unique<RawSequenceWriter>(folder, description);
  throw Error("format " + Quoted(format) + ": is none of " + Joined(SequenceFormats()));
}

std::unique_ptr<RecordedSequence> OpenSequence(const std::string& format, const fs::path& folder,
                                               const ReadingOptions& options) {
  SILT_CHECK(options.take_every >= 1);
  const std::string found = format == "auto" ? FormatOf(folder) : format;
  if (found == "tum") {
    TumSequenceOptions reading;
    reading.take_every = options.take_every;
    if (options.association_tolerance_s) {
      reading.association_tolerance_s = *options.association_tolerance_s;
    }
    return std::make_unique<TumSequence>(folder, reading, options.camera);
  }
  if (options.camera.fx != 0) {
    throw Error(folder.string() + ": a camera can be given for a tum folder alone; this is " +
                found);
  }
  if (options.association_tolerance_s) {
    throw Error(folder.string() +
                ": a tolerance can be given for a tum folder alone, whose lists " +
                "have times of their own; this is " + found);
  }
  std::unique_ptr<RecordedSequence> all;
  if (found == "icl") {
    all = std::make_unique<IclSequence>(folder);
  } else if (found == "euroc") {
    all = std::make_unique<EurocSequence>(folder);
  } else if (found == "raw") {
    all = std::make_unique<RawSequence>(folder);
  } else {
    throw Error("format " + Quoted(found) +
                ": is none that can be read: " + Joined(ReadableFormats()));
  }
  if (options.take_every == 1) return all;
  return std::make_unique<ThinnedSequence>(std::move(all), options.take_every);
}

}  // namespace silt
