// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "reports/hdf5_file.h"

#include <hdf5.h>

#include <algorithm>
#include <array>

#include "reports/report.h"

namespace placode::reports {
namespace {

constexpr hsize_t kRowsInChunk = 512;
constexpr unsigned kDeflate = 4;

/// An identifier of the library, and how it is given back.
class Handle {
 public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
    ~Handle() {
        if (id_ >= 0) close_(id_);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    operator hid_t() const { return id_; }  // NOLINT: as the library's functions take it

 private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

}  // namespace

struct Hdf5File::Impl {
    std::string path;
    hid_t file = -1;

    [[noreturn]] void fail(const std::string& place) const {
        throw ReportError(path + ": " + place +
                          " cannot be written or read; is the disk full, or the file damaged?");
    }
    hid_t need(hid_t id, const std::string& place) const {
        if (id < 0) fail(place);
        return id;
    }
    void need_done(herr_t status, const std::string& place) const {
        if (status < 0) fail(place);
    }

    void write_values(const std::string& place, const std::vector<hsize_t>& size,
                      const double* values) const {
        const auto axes = static_cast<int>(size.size());
        const Handle space(need(H5Screate_simple(axes, size.data(), nullptr), place), H5Sclose);
        const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
        H5Pset_create_intermediate_group(links, 1);
        const Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        if (size[0] > 0) {
            std::vector<hsize_t> chunk = size;
            chunk[0] = std::min(chunk[0], kRowsInChunk);
            H5Pset_chunk(layout, axes, chunk.data());
            H5Pset_shuffle(layout);
            H5Pset_deflate(layout, kDeflate);
        }
        const Handle set(
            need(H5Dcreate2(file, place.c_str(), H5T_IEEE_F64LE, space, links, layout, H5P_DEFAULT),
                 place),
            H5Dclose);
        need_done(H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), place);
    }

    /// Of a group, which is made where it is not there.
    void write_attribute(const std::string& place, const std::string& name, hid_t type,
                         const void* value) const {
        const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
        H5Pset_create_intermediate_group(links, 1);
        const bool there = H5Lexists(file, place.c_str(), H5P_DEFAULT) > 0;
        const Handle group(
            need(there ? H5Gopen2(file, place.c_str(), H5P_DEFAULT)
                       : H5Gcreate2(file, place.c_str(), links, H5P_DEFAULT, H5P_DEFAULT),
                 place),
            H5Gclose);
        const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
        const Handle attribute(
            need(H5Acreate2(group, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), name),
            H5Aclose);
        need_done(H5Awrite(attribute, type, value), name);
    }
};

Hdf5File::Hdf5File(const std::string& path, Open how) : impl_(std::make_unique<Impl>()) {
    // Its own messages on the standard error are for programmers; ours name the file.
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    impl_->path = path;
    // Without times of objects, so that the same data give the same bytes: none are kept by
    // default in this version of the format.
    impl_->file = how == Open::kCreate
                      ? H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)
                      : H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (impl_->file < 0) impl_->fail("the file");
}

Hdf5File::~Hdf5File() {
    if (impl_->file >= 0) H5Fclose(impl_->file);
}

void Hdf5File::write(const std::string& place, const Matrix& matrix) {
    impl_->write_values(place, {matrix.rows, matrix.columns}, matrix.values.data());
}

void Hdf5File::write(const std::string& place, const std::vector<double>& numbers) {
    impl_->write_values(place, {numbers.size()}, numbers.data());
}

void Hdf5File::write(const std::string& place, const std::vector<std::string>& words) {
    size_t longest = 1;
    for (const std::string& word : words) longest = std::max(longest, word.size());
    std::string bytes;
    for (const std::string& word : words) bytes += word + std::string(longest - word.size(), '\0');
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, longest);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    const std::array<hsize_t, 1> size{words.size()};
    const Handle space(H5Screate_simple(1, size.data(), nullptr), H5Sclose);
    const Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    H5Pset_create_intermediate_group(links, 1);
    const Handle set(impl_->need(H5Dcreate2(impl_->file, place.c_str(), type, space, links,
                                            H5P_DEFAULT, H5P_DEFAULT),
                                 place),
                     H5Dclose);
    impl_->need_done(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), place);
}

void Hdf5File::attribute(const std::string& place, const std::string& name,
                         const std::string& text) {
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type, H5T_VARIABLE);
    H5Tset_cset(type, H5T_CSET_UTF8);
    const char* const value = text.c_str();
    impl_->write_attribute(place, name, type, &value);
}

void Hdf5File::attribute(const std::string& place, const std::string& name, int64_t number) {
    impl_->write_attribute(place, name, H5T_NATIVE_INT64, &number);
}

void Hdf5File::attribute(const std::string& place, const std::string& name, double number) {
    impl_->write_attribute(place, name, H5T_NATIVE_DOUBLE, &number);
}

Matrix Hdf5File::matrix(const std::string& place) const {
    const Handle set(impl_->need(H5Dopen2(impl_->file, place.c_str(), H5P_DEFAULT), place),
                     H5Dclose);
    const Handle space(impl_->need(H5Dget_space(set), place), H5Sclose);
    std::array<hsize_t, 2> size{0, 1};
    const int axes = H5Sget_simple_extent_ndims(space);
    if (axes < 1 || axes > 2) impl_->fail(place);
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
    Matrix matrix{size[0], size[1], std::vector<double>(size[0] * size[1])};
    impl_->need_done(
        H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, matrix.values.data()),
        place);
    return matrix;
}

}  // namespace placode::reports
