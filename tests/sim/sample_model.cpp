// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include "sample_model.h"

#include <archive.h>
#include <archive_entry.h>

#include <cstdint>
#include <cstring>
#include <opencv2/imgcodecs.hpp>
#include <vector>

namespace silt::sim {
namespace {

void AddEntry(archive* zip, const std::string& name, const std::string& contents) {
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, name.c_str());
  archive_entry_set_size(entry, la_int64_t(contents.size()));
  archive_entry_set_filetype(entry, AE_IFREG);
  archive_entry_set_perm(entry, 0644);
  archive_write_header(zip, entry);
  archive_write_data(zip, contents.data(), contents.size());
  archive_entry_free(entry);
}

}  // namespace

std::string SamplePng(bool alpha) {
  const std::uint8_t white_alpha = alpha ? 0 : 255;
  cv::Mat image(2, 2, CV_8UC4);
  image.at<cv::Vec4b>(0, 0) = {0, 0, 255, 255};
  image.at<cv::Vec4b>(0, 1) = {0, 255, 0, 255};
  image.at<cv::Vec4b>(1, 0) = {255, 0, 0, 255};
  image.at<cv::Vec4b>(1, 1) = {255, 255, 255, white_alpha};
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", image, bytes);
  return {bytes.begin(), bytes.end()};
}

std::string SampleObj() {
  return "mtllib sheet.mtl\n"
         "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n"
         "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
         "usemtl paper\n"
         "f 1/1 2/2 3/3 4/4\n";
}

std::string SampleMtl(const std::string& picture) {
  return "newmtl paper\nKd 0.5 0.25 1\nmap_Kd " + picture + "\n";
}

std::string ZipOf(const std::map<std::string, std::string>& files) {
  std::vector<char> buffer(1 << 20);
  std::size_t used = 0;
  archive* zip = archive_write_new();
  archive_write_set_format_zip(zip);
  archive_write_open_memory(zip, buffer.data(), buffer.size(), &used);
  for (const auto& [name, contents] : files) AddEntry(zip, name, contents);
  archive_write_close(zip);
  archive_write_free(zip);
  return {buffer.data(), used};
}

std::string Base64(const std::string& bytes) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8 | (i + k < bytes.size() ? std::uint8_t(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[word >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

std::string SampleGltf(const std::string& node) {
  const float vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, /*texcoords:*/ 0, 0, 1, 0, 0, 1};
  std::string buffer(sizeof vertices, '\0');
  std::memcpy(buffer.data(), vertices, sizeof vertices);
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{)" + node +
         R"("mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},
"material":0}]}],"materials":[{"name":"paper","pbrMetallicRoughness":{
"baseColorFactor":[0.5,0.25,1,1],"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
         Base64(SamplePng()) + R"("}],"buffers":[{"byteLength":60,
"uri":"data:application/octet-stream;base64,)" +
         Base64(buffer) + R"("}],"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":36},
{"buffer":0,"byteOffset":36,"byteLength":24}],"accessors":[{"bufferView":0,"componentType":5126,
"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5126,"count":3,"type":"VEC2"}]})";
}

}  // namespace silt::sim
