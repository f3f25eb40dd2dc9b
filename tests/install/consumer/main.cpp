// SPDX-FileCopyrightText: 2026 the silt authors
// SPDX-License-Identifier: MIT
#include <cstdio>

#include "silt/core/error.h"
#include "silt/sim/scene.h"
#include "silt/tracker/kernel/residual.h"
#include "silt/tracker/options.h"
#ifdef WITH_CUDA
#include "silt/cuda/devices.h"
#endif

// Loads the scene given and tells its size.
int main(int, char** argv) {
  try {
#ifdef WITH_CUDA
    std::printf("%zu GPUs\n", silt::cuda::DeviceList().size());
#endif
    const silt::sim::Scene scene = silt::sim::LoadScene(argv[1]);
    std::printf("%s: %zu triangles, %d pyramid levels\n", scene.name.c_str(),
                scene.mesh.triangles.size(), silt::tracker::PaperPreset().alignment.levels());
  } catch (const silt::Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
