// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

#include "silt/cuda/devices.h"

// What is told of a device that does not serve: one line each, without an end.
namespace silt::cuda {

// As CUDA counts them: 13000 is "13.0", and 0 "none".
std::string VersionText(int version);

// Where no device is found: by a driver that does not know the CUDA that this program was compiled
// with, or at all.
std::string WhyNoDevice(int driver_version, int toolkit_version);

// What the tracker's kernels need and this device does not have; empty where it has all.
std::string WhatLacks(const Device& device);

// How many blocks are to run at once of those that a device can hold: so many, or fewer where a
// limit is given as text (null: none). Throws silt::Error where that is not a number above 0.
int LimitedBlocks(int resident, const char* limit);

// Of memory that it does not have.
std::string OutOfMemoryText(std::size_t bytes);

}  // namespace silt::cuda
