// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// placode.h for Python: handles as objects, statuses as exceptions, arrays without copies. All of
// Gymnasium's interface is Python (placode/env.py, placode/vector.py).

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "interface/placode.h"

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Raises what placode/errors.py has for this status.
[[noreturn]] void raise(placode_status status, const std::string& words) {
    const py::object error =
        py::module_::import("placode.errors").attr("of_status")(static_cast<int>(status), words);
    PyErr_SetObject(py::reinterpret_borrow<py::object>(error.get_type()).ptr(), error.ptr());
    throw py::error_already_set();
}

/// An array that something is written into: of this type, without gaps, of this size.
template <class T>
T* room(py::array& array, size_t size, const char* what) {
    if (!py::isinstance<py::array_t<T>>(array) || (array.flags() & py::array::c_style) == 0 ||
        !array.writeable() || static_cast<size_t>(array.size()) != size)
        raise(PLACODE_BAD_ARGUMENT,
              std::string(what) + ": expected a writable array of " + std::to_string(size) + " " +
                  std::string(py::str(py::dtype::of<T>())) + " without gaps, found " +
                  std::string(py::str(array.dtype())) + " of " + std::to_string(array.size()));
    return static_cast<T*>(array.mutable_data());
}

struct Fields {
    explicit Fields(size_t most_kept) : handle(placode_fields_new(most_kept), placode_fields_free) {
        if (!handle) raise(PLACODE_NO_MEMORY, "there is not enough memory");
    }
    [[nodiscard]] std::vector<std::string> tasks() const {
        std::vector<std::string> ids(1);
        for (const char* c = placode_fields_tasks(handle.get()); *c != '\0'; ++c) {
            if (*c == '\n')
                ids.emplace_back();
            else
                ids.back() += *c;
        }
        return ids;
    }
    std::shared_ptr<placode_fields> handle;
};

struct Moment {
    std::shared_ptr<placode_moment> handle{placode_moment_new(), placode_moment_free};
};

class Environment;
/// While it works without the interpreter's lock, nobody else may use an environment.
class Use {
 public:
    explicit Use(std::vector<Environment*> used);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

 private:
    std::vector<Environment*> used_;
};

class Environment {
 public:
    Environment(const Fields& fields, const std::string& task, const py::kwargs& given)
        : fields_(fields.handle) {
        placode_options options;
        placode_options_init(&options);
        std::string scene;
        for (const auto& [key, value] : given) set(options, scene, py::str(key), value);
        if (!scene.empty()) options.scene_changes = scene.c_str();
        handle_.reset(placode_environment_new(fields_.get(), task.c_str(), &options),
                      placode_environment_free);
        if (!handle_) raise(PLACODE_BAD_DEFINITION, placode_fields_error(fields_.get()));
    }

    void check(placode_status status) const {
        if (status != PLACODE_OK) raise(status, placode_error(handle_.get()));
    }
    [[nodiscard]] placode_environment* get() const { return handle_.get(); }

    void reset(uint64_t seed) {
        const Use use({this});
        placode_status status = PLACODE_OK;
        {
            const py::gil_scoped_release free;
            status = placode_reset(get(), seed);
        }
        check(status);
    }
    py::tuple step(const Numbers& action, int frames, bool finish) {
        const Use use({this});
        placode_outcome out{};
        out.size = sizeof out;
        placode_status status = PLACODE_OK;
        const double* numbers = action.data();
        const auto count = static_cast<size_t>(action.size());
        {
            const py::gil_scoped_release free;
            status = placode_step(get(), numbers, count, frames, finish ? 1 : 0, &out);
        }
        check(status);
        return py::make_tuple(out.reward, out.end, out.success != 0, out.score, out.approach,
                              out.frames);
    }
    void observe(py::array out) {
        const Use use({this});
        const size_t size = placode_observation_size(get());
        check(placode_observe(get(), room<double>(out, size, "observation"), size));
    }
    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (size_t i = 0; i < placode_observation_size(get()); ++i)
            all.emplace_back(placode_observation_name(get(), i));
        return all;
    }
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> tools() const {
        std::vector<std::pair<std::string, std::string>> all;
        for (size_t i = 0; i < placode_tool_count(get()); ++i)
            all.emplace_back(placode_tool_kind(get(), i), placode_tool_hand(get(), i));
        return all;
    }
    py::tuple contour() {
        const Use use({this});
        size_t n = 0;
        check(placode_contour(get(), nullptr, nullptr, 0, &n));
        py::array_t<double> points({n, size_t{3}});
        py::array_t<uint8_t> cut(static_cast<py::ssize_t>(n));
        check(placode_contour(get(), points.mutable_data(), cut.mutable_data(), n, &n));
        return py::make_tuple(points, cut);
    }
    py::tuple surface() {
        const Use use({this});
        size_t v = 0, t = 0;
        check(placode_surface(get(), nullptr, nullptr, 0, nullptr, 0, &v, &t));
        py::array_t<float> xyz({v, size_t{3}}), damage({v, size_t{4}});
        py::array_t<int32_t> triangles({t, size_t{3}});
        check(placode_surface(get(), xyz.mutable_data(), damage.mutable_data(), v,
                              triangles.mutable_data(), t, &v, &t));
        return py::make_tuple(xyz, triangles, damage);
    }
    py::list events(size_t first) {
        const Use use({this});
        size_t count = 0;
        check(placode_events(get(), 0, nullptr, 0, &count));
        std::vector<placode_event> events(count > first ? count - first : 0);
        check(placode_events(get(), first, events.data(), events.size(), &count));
        py::list all;
        for (const placode_event& e : events)
            all.append(py::make_tuple(
                e.time_s, placode_event_name(e.kind), e.tool, e.value, e.value2,
                py::make_tuple(e.rest_position_m[0], e.rest_position_m[1], e.rest_position_m[2])));
        return all;
    }
    std::string score_json() {
        const Use use({this});
        const char* json = nullptr;
        check(placode_score_json(get(), &json));
        return json;
    }
    py::tuple score() {
        const Use use({this});
        double points = 0;
        int32_t passed = 0;
        check(placode_score(get(), &points, &passed));
        return py::make_tuple(points, passed != 0);
    }
    Moment save() {
        const Use use({this});
        Moment moment;
        check(placode_save(get(), moment.handle.get()));
        return moment;
    }
    void restore(const Moment& moment) {
        const Use use({this});
        check(placode_restore(get(), moment.handle.get()));
    }
    uint64_t state_hash() {
        const Use use({this});
        uint64_t hash = 0;
        check(placode_state_hash(get(), &hash));
        return hash;
    }
    void write_recording(const std::string& path) {
        const Use use({this});
        check(placode_write_recording(get(), path.c_str()));
    }

 private:
    friend class Use;

    static void set(placode_options& o, std::string& scene, const std::string& key,
                    const py::handle& value) {
        if (key == "threads")
            o.threads = value.cast<int32_t>();
        else if (key == "absolute")
            o.units = value.cast<bool>() ? PLACODE_ABSOLUTE : PLACODE_NORMALISED;
        else if (key == "sparse")
            o.sparse = value.cast<bool>() ? 1 : 0;
        else if (key == "record")
            o.record = value.cast<bool>() ? 1 : 0;
        else if (key == "fields")
            o.fields = value.cast<uint64_t>();
        else if (key == "speed_m_s")
            o.speed_m_s = value.cast<double>();
        else if (key == "time_limit_s")
            o.time_limit_s = value.cast<double>();
        else if (key == "start_spread_m")
            o.start_spread_m = value.cast<double>();
        else if (key == "judge_every_s")
            o.judge_every_s = value.cast<double>();
        else if (key == "approach_weight")
            o.approach_weight = value.cast<double>();
        else if (key == "scene_changes")
            scene = value.cast<std::string>();
        else
            throw py::type_error("no option \"" + key + "\"");
    }

    std::shared_ptr<placode_fields> fields_;
    std::shared_ptr<placode_environment> handle_;
    std::atomic_flag busy_;
};

Use::Use(std::vector<Environment*> used) {
    for (Environment* environment : used) {
        if (environment->busy_.test_and_set()) {
            for (Environment* mine : used_) mine->busy_.clear();
            raise(PLACODE_BAD_ARGUMENT, "another thread is using this environment");
        }
        used_.push_back(environment);
    }
}

Use::~Use() {
    for (Environment* environment : used_) environment->busy_.clear();
}

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

class Batch {
 public:
    Batch(std::vector<Environment*> environments, int autoreset, int threads)
        : environments_(std::move(environments)) {
        std::vector<placode_environment*> handles;
        for (const Environment* environment : environments_) handles.push_back(environment->get());
        if (handles.empty()) raise(PLACODE_BAD_ARGUMENT, "a batch has at least one environment");
        handle_.reset(placode_batch_new(handles.data(), handles.size(),
                                        static_cast<placode_autoreset>(autoreset), threads),
                      placode_batch_free);
        if (!handle_) raise(PLACODE_BAD_ARGUMENT, placode_error(handles[0]));
        observation_ = placode_observation_size(handles[0]);
        action_ = placode_tool_count(handles[0]) * PLACODE_ACTION_SIZE;
    }
    void reset(const std::vector<uint64_t>& seeds, py::array observations) {
        const Use use(environments_);
        double* out = room<double>(observations, seeds.size() * observation_, "observations");
        if (seeds.size() != environments_.size())
            raise(PLACODE_BAD_ARGUMENT, "expected one seed for each environment");
        placode_status status = PLACODE_OK;
        {
            const py::gil_scoped_release free;
            status = placode_batch_reset(handle_.get(), seeds.data(), out);
        }
        check(status);
    }
    void step(const Numbers& actions, int frames, py::array observations,
              const py::object& final_observations, py::array rewards, py::array terminated,
              py::array truncated, py::array success) {
        const Use use(environments_);
        const size_t n = environments_.size();
        if (static_cast<size_t>(actions.size()) != n * action_)
            raise(PLACODE_BAD_ARGUMENT, "actions: expected " + std::to_string(n * action_) +
                                            " numbers, found " + std::to_string(actions.size()));
        double* last = nullptr;
        if (!final_observations.is_none()) {
            py::array array = final_observations.cast<py::array>();
            last = room<double>(array, n * observation_, "final observations");
        }
        double* seen = room<double>(observations, n * observation_, "observations");
        double* reward = room<double>(rewards, n, "rewards");
        uint8_t* flags[] = {room<uint8_t>(terminated, n, "terminated"),
                            room<uint8_t>(truncated, n, "truncated"),
                            room<uint8_t>(success, n, "success")};
        const double* numbers = actions.data();
        placode_status status = PLACODE_OK;
        {
            const py::gil_scoped_release free;
            status = placode_batch_step(handle_.get(), numbers, frames, seen, last, reward,
                                        flags[0], flags[1], flags[2]);
        }
        check(status);
    }

 private:
    void check(placode_status status) const {
        if (status != PLACODE_OK) raise(status, placode_batch_error(handle_.get()));
    }

    std::vector<Environment*> environments_;
    std::shared_ptr<placode_batch> handle_;
    size_t observation_ = 0, action_ = 0;
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
             py::arg("truncated").noconvert(), py::arg("success").noconvert());
}
