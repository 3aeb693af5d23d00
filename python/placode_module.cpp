// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode.h for Python: handles as objects, statuses as exceptions, arrays without copies. All of
// Gymnasium's interface is Python (placode/env.py, placode/vector.py).

#include <pybind11/stl.h>

#include "python/batch.h"

using namespace placode::python;

namespace {

class Expert {
 public:
    Expert(Environment& environment, const std::string& level, uint64_t seed)
        : environment_(environment) {
        const Use use({&environment});
        handle_.reset(placode_expert_new(environment.get(), level.c_str(), seed),
                      placode_expert_free);
        if (!handle_) raise(PLACODE_BAD_ARGUMENT, placode_error(environment.get()));
    }
    bool act(int frames, py::array out) {
        const Use use({&environment_});
        const size_t size = placode_tool_count(environment_.get()) * PLACODE_ACTION_SIZE;
        int32_t done = 0;
        environment_.check(placode_expert_act(environment_.get(), handle_.get(), frames,
                                              room<double>(out, size, "action"), size, &done));
        return done != 0;
    }

 private:
    Environment& environment_;
    std::shared_ptr<placode_expert> handle_;
};

class Picture {
 public:
    Picture(Environment& environment, int width, int height)
        : environment_(environment), width_(width), height_(height) {
        const Use use({&environment});
        handle_.reset(placode_picture_new(environment.get(), width, height), placode_picture_free);
        if (!handle_) raise(PLACODE_NO_PICTURE, placode_error(environment.get()));
    }
    py::array_t<uint8_t> draw() {
        const Use use({&environment_});
        py::array_t<uint8_t> rgb({height_, width_, 3});
        environment_.check(placode_draw(environment_.get(), handle_.get(), rgb.mutable_data(),
                                        static_cast<size_t>(rgb.size())));
        return rgb;
    }

 private:
    Environment& environment_;
    int width_, height_;
    std::shared_ptr<placode_picture> handle_;
};

}  // namespace

PYBIND11_MODULE(_placode, m) {
    m.doc() = "placode.h for Python; use the package placode";
    m.attr("API_VERSION") = placode_api_version();
    m.attr("VERSION") = placode_version();
    m.attr("ACTION_SIZE") = PLACODE_ACTION_SIZE;
    py::class_<Fields>(m, "Fields")
        .def(py::init<size_t>(), py::arg("most_kept") = 8)
        .def_property_readonly("built",
                               [](const Fields& f) { return placode_fields_built(f.handle.get()); })
        .def("tasks", &Fields::tasks);
    py::class_<Moment>(m, "Moment").def_property_readonly("nbytes", [](const Moment& moment) {
        return placode_moment_bytes(moment.handle.get());
    });
    py::class_<Environment>(m, "Environment")
        .def(py::init<const Fields&, const std::string&, const py::kwargs&>())
        .def("reset", &Environment::reset)
        .def("step", &Environment::step, py::arg("action"), py::arg("frames") = 1,
             py::arg("finish") = false)
        .def("observe", &Environment::observe, py::arg("out").noconvert())
        .def("contour", &Environment::contour)
        .def("surface", &Environment::surface)
        .def("events", &Environment::events, py::arg("first") = 0)
        .def("score", &Environment::score)
        .def("score_json", &Environment::score_json)
        .def("save", &Environment::save)
        .def("restore", &Environment::restore)
        .def("state_hash", &Environment::state_hash)
        .def("write_recording", &Environment::write_recording)
        .def_property_readonly("observation_names", &Environment::names)
        .def_property_readonly("tools", &Environment::tools)
        .def_property_readonly("task_id",
                               [](const Environment& e) { return placode_task_id(e.get()); })
        .def_property_readonly("task_json",
                               [](const Environment& e) { return placode_task_json(e.get()); })
        .def_property_readonly("time_limit_s",
                               [](const Environment& e) { return placode_time_limit_s(e.get()); });
    py::class_<Expert>(m, "Expert")
        .def(py::init<Environment&, const std::string&, uint64_t>(), py::keep_alive<1, 2>())
        .def("act", &Expert::act, py::arg("frames"), py::arg("out").noconvert());
    py::class_<Picture>(m, "Picture")
        .def(py::init<Environment&, int, int>(), py::keep_alive<1, 2>())
        .def("draw", &Picture::draw);
    py::class_<Batch>(m, "Batch")
        .def(py::init<std::vector<Environment*>, int, int>(), py::keep_alive<1, 2>())
        .def("reset", &Batch::reset, py::arg("seeds"), py::arg("observations").noconvert())
        .def("step", &Batch::step, py::arg("actions"), py::arg("frames"),
             py::arg("observations").noconvert(), py::arg("final_observations"),
             py::arg("rewards").noconvert(), py::arg("terminated").noconvert(),
             py::arg("truncated").noconvert(), py::arg("success").noconvert())
        .def("finish", &Batch::finish, py::arg("which").noconvert())
        .def("last", &Batch::last, py::arg("score_parts").noconvert(),
             py::arg("approach_parts").noconvert(), py::arg("points").noconvert());
}
