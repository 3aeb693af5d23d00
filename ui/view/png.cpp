// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view/png.h"

#include "ui/view/gl_program.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace placode::view {

using namespace sim;

void write_png(const std::string& path, int width, int height, const std::vector<uint8_t>& rgb) {
    if (stbi_write_png(path.c_str(), width, height, 3, rgb.data(), 3 * width) == 0) {
        throw ViewError("cannot write picture " + path +
                        "; does the folder exist, is there space?");
    }
}

}  // namespace placode::view
