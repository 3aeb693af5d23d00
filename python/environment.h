// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Handles of placode.h as objects of Python: fields, moments, and one environment.

#include <pybind11/stl.h>

#include <atomic>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/arrays.h"

namespace placode::python {

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

inline Use::Use(std::vector<Environment*> used) {
    for (Environment* environment : used) {
        if (environment->busy_.test_and_set()) {
            for (Environment* mine : used_) mine->busy_.clear();
            raise(PLACODE_BAD_ARGUMENT, "another thread is using this environment");
        }
        used_.push_back(environment);
    }
}

inline Use::~Use() {
    for (Environment* environment : used_) environment->busy_.clear();
}

}  // namespace placode::python
