// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Haply Inverse3 through its Inverse service: JSON over a WebSocket of this computer. The service
// answers commands only, so that every tick sends a force, if only zero, and reads the state that
// the last one brought. Spellings differ between versions of the service; unknown keys are passed
// over, and no force is given unless it says that the arm is calibrated and ready.
#include <charconv>
#include <cmath>
#include <cstring>

#include "haptics/arm_hands.h"
#include "haptics/axes.h"
#include "haptics/json_scan.h"
#include "haptics/real_time.h"
#include "haptics/web_socket.h"

namespace placode::haptics {

namespace {

constexpr int64_t kSilenceNs = 100'000'000;  // older states count as lost
constexpr int64_t kOpenNs = 1'500'000'000;   // patience when the program starts,
constexpr int64_t kNobodyNs = 300'000'000;   // and while nobody even takes the call
constexpr size_t kMaxFound = 4, kIdLength = 32;
constexpr std::string_view kHello = R"({"session":{"force_render_full_state":{}}})";

struct Id {
    std::array<char, kIdLength> text{};
    void set(std::string_view name) noexcept {
        text.fill('\0');
        std::memcpy(text.data(), name.data(), std::min(name.size(), text.size() - 1));
    }
    [[nodiscard]] std::string_view view() const noexcept { return text.data(); }
};

/// An arm or a grip as the service describes it.
struct Found {
    Id id;
    Vec3 position = Vec3::Zero();  // axes of the device
    Quat orientation = Quat::Identity();
    uint32_t buttons = 0;
    bool left = false, handed = false, calibrated = false, ready = false;
    int64_t seen_ns = 0;
};

class HaplyDevice final : public ArmHands {
 public:
    HaplyDevice(const DeviceConfig& config, std::vector<sim::Hand> hands,
                const std::vector<std::string>& ids)
        : ArmHands(config, hands),
          hands_(hands),
          axes_(device_axes(config.station.text("haply.axes"), "haply.axes")),
          max_force_n_(config.station.number("haply.force_n")),
          socket_(config.station.text("haply.host"),
                  static_cast<int>(config.station.number("haply.port")), "/") {
        for (size_t i = 0; i < hands_.size(); ++i) wanted_[i].set(ids[i]);
        wait_for_arms(config.station);
    }

    void stop() noexcept override {
        for (ArmForce& force : last_) force = {};
        send_forces();
        socket_.close();
    }

 protected:
    void sense(int64_t t_ns, std::span<ArmSample> samples) noexcept override {
        pump(t_ns);
        for (size_t a = 0; a < samples.size(); ++a) {
            const Found* arm = arm_of(a);
            if (arm == nullptr || t_ns - arm->seen_ns > kSilenceNs ||
                socket_.state() != WebSocket::State::kOpen)
                continue;  // lost
            ArmSample& sample = samples[a];
            sample.status =
                arm->calibrated && arm->ready ? DeviceStatus::kReady : DeviceStatus::kNotCalibrated;
            sample.held = true;  // the arm does not know; its force begins by a ramp
            sample.position_m = axes_ * arm->position;
            if (a < grip_count_ && t_ns - grips_[a].seen_ns <= kSilenceNs) {
                const Quat& q = grips_[a].orientation;
                sample.orientation = q;
                // Turn about the grip's own long axis.
                sample.roll_rad = 2 * std::atan2(q.z(), q.w());
                sample.buttons = grips_[a].buttons;
            }
        }
    }

    void drive(std::span<const ArmForce> forces) noexcept override {
        for (size_t a = 0; a < forces.size(); ++a) last_[a] = forces[a];
        send_forces();
    }

    [[nodiscard]] std::vector<DeviceInfo> arm_info() const override {
        std::vector<DeviceInfo> infos;
        for (size_t a = 0; a < hands_.size(); ++a) {
            DeviceInfo info;
            info.vendor = "Haply";
            info.model = "Inverse3";
            if (const Found* arm = arm_of(a)) info.serial = arm->id.view();
            info.driver = "Inverse service";
            info.dof_sensed = 3;
            info.dof_force = 3;
            info.left_hand = hands_[a] == sim::Hand::kLeft;
            info.max_force_n = max_force_n_;
            infos.push_back(info);
        }
        return infos;
    }

 private:
    // The arm with the wanted id; without one, the first of the wanted side.
    [[nodiscard]] const Found* arm_of(size_t a) const noexcept {
        const bool left = hands_[a] == sim::Hand::kLeft && hands_.size() > 1;
        for (size_t i = 0; i < arm_count_; ++i) {
            const Found& arm = arms_[i];
            const bool side = hands_.size() == 1 || arm.left == left;
            if (wanted_[a].view().empty() ? side : arm.id.view() == wanted_[a].view()) return &arm;
        }
        return nullptr;
    }

    void wait_for_arms(const Station& station) {
        const int64_t until = monotonic_ns() + kOpenNs;
        bool all = false;
        const int64_t nobody = monotonic_ns() + kNobodyNs;
        while (!all && monotonic_ns() < (socket_.connections() == 0 ? nobody : until)) {
            pump(monotonic_ns());
            send_forces();
            all = true;
            for (size_t a = 0; a < hands_.size(); ++a) all = all && arm_of(a) != nullptr;
            sleep_until(monotonic_ns() + 1'000'000);
        }
        if (!all) throw DeviceError(absent(station));
        for (size_t a = 0; a < hands_.size(); ++a) {
            const Found& arm = *arm_of(a);
            const bool left = hands_[a] == sim::Hand::kLeft;
            if (!wanted_[a].view().empty() && arm.handed && arm.left != left)
                throw DeviceError("haply: the station file names " + std::string(arm.id.view()) +
                                  " as the " + (left ? "left" : "right") +
                                  " arm, but it is set up for the other hand; change it in the "
                                  "Haply hub or swap haply.right and haply.left");
        }
    }

    [[nodiscard]] std::string absent(const Station& station) const {
        const std::string place = station.text("haply.host") + ":" + station.text("haply.port");
        if (socket_.connections() == 0)
            return "haply: no Inverse service answers at ws://" + place +
                   "/. Install and start the Haply Inverse service 3.5 or newer; its address can "
                   "be changed by haply.host and haply.port in the station file.";
        std::string found;
        for (size_t i = 0; i < arm_count_; ++i)
            found += (i > 0 ? ", " : "") + std::string(arms_[i].id.view()) +
                     (arms_[i].left ? " (left)" : " (right)");
        return "haply: the Inverse service at " + place + " runs, but not every arm is there; it " +
               "shows " + (found.empty() ? "none" : found) +
               ". Plug in and switch on the Inverse3, or change haply.right and haply.left.";
    }

    void pump(int64_t t_ns) noexcept {
        socket_.step(t_ns);
        if (socket_.state() == WebSocket::State::kOpen && greeted_ != socket_.connections() &&
            socket_.send_text(kHello)) {
            greeted_ = socket_.connections();
            for (Found& arm : arms_) arm.calibrated = arm.ready = false;
        }
        std::string_view text;
        while (socket_.next_message(text)) read_message(text, t_ns);
    }

    void read_message(std::string_view text, int64_t t_ns) noexcept {
        JsonScan scan(text);
        scan.object([&](std::string_view key) {
            if (key == "inverse3")
                scan.array([&] { read_one(scan, t_ns, arms_, arm_count_); });
            else if (key.find("verse_grip") != std::string_view::npos)
                scan.array([&] { read_one(scan, t_ns, grips_, grip_count_); });
        });
    }

    // Reads into a spare place first: the id may come after the state.
    void read_one(JsonScan& scan, int64_t t_ns, std::array<Found, kMaxFound>& found,
                  size_t& count) noexcept {
        JsonScan ahead = scan;
        Id id;
        ahead.object([&](std::string_view key) {
            if (key == "device_id") id.set(ahead.text());
        });
        if (id.view().empty()) return;
        size_t place = 0;
        while (place < count && found[place].id.view() != id.view()) ++place;
        if (place == found.size()) return;
        Found& one = found[place];
        if (place == count) {
            one = {};
            one.id = id;
            ++count;
        }
        scan.object([&](std::string_view key) {
            if (key == "config") read_config(scan, one);
            if (key == "state") read_state(scan, one, t_ns);
            if (key == "status") read_status(scan, one);
        });
    }

    static void read_config(JsonScan& scan, Found& one) noexcept {
        scan.object([&](std::string_view key) {
            if (key != "handedness") return;
            const std::string_view side = scan.text();
            one.handed = side == "left" || side == "right";
            one.left = side == "left";
        });
    }

    static void read_status(JsonScan& scan, Found& one) noexcept {
        scan.object([&](std::string_view key) {
            if (key == "calibrated") one.calibrated = scan.truth(false);
            if (key == "ready") one.ready = scan.truth(false);
        });
    }

    static void read_state(JsonScan& scan, Found& one, int64_t t_ns) noexcept {
        const double none = std::nan("");
        scan.object([&](std::string_view key) {
            if (key == "cursor_position") {
                Vec3 position(none, none, none);
                scan.object([&](std::string_view axis) {
                    if (axis.size() == 1 && axis[0] >= 'x' && axis[0] <= 'z')
                        position[axis[0] - 'x'] = scan.number(none);
                });
                one.position = position;  // a part that is missing is a doubt
                one.seen_ns = t_ns;
            } else if (key == "orientation") {
                double w = none, x = none, y = none, z = none;
                scan.object([&](std::string_view part) {
                    if (part == "w") w = scan.number(none);
                    if (part == "x") x = scan.number(none);
                    if (part == "y") y = scan.number(none);
                    if (part == "z") z = scan.number(none);
                });
                const Quat q(w, x, y, z);
                if (q.coeffs().allFinite() && q.norm() > 0.5) one.orientation = q.normalized();
                one.seen_ns = t_ns;
            } else if (key == "buttons") {
                one.buttons = read_buttons(scan);
            } else if (key == "button") {
                one.buttons = scan.truth(false) ? 1u : 0u;
            }
        });
    }

    // {a, b, c, home}, {button_0..3} or one {button}.
    static uint32_t read_buttons(JsonScan& scan) noexcept {
        uint32_t held = 0;
        scan.object([&](std::string_view key) {
            int bit = -1;
            if (key == "a" || key == "button_0" || key == "button") bit = 0;
            if (key == "b" || key == "button_1") bit = 1;
            if (key == "c" || key == "button_2") bit = 2;
            if (key == "home" || key == "button_3") bit = 3;
            if (bit < 0) return;
            if (scan.truth(false) || scan.number(0) > 0.5) held |= 1u << bit;
        });
        return held;
    }

    void send_forces() noexcept {
        if (arm_count_ == 0) {
            // Nothing is known yet: ask, or the service stays silent.
            if (greeted_ > 0 && greeted_ == socket_.connections()) socket_.send_text(kHello);
            return;
        }
        std::array<char, 1024> text{};
        char* at = text.data();
        char* const end = text.data() + text.size();
        const auto put = [&](std::string_view part) {
            if (static_cast<size_t>(end - at) < part.size()) return;
            std::memcpy(at, part.data(), part.size());
            at += part.size();
        };
        const auto put_number = [&](double value) {
            const auto [next, error] = std::to_chars(at, end, value, std::chars_format::fixed, 5);
            if (error == std::errc{}) at = next;
        };
        put(R"({"inverse3":[)");
        bool first = true;
        for (size_t a = 0; a < hands_.size(); ++a) {
            const Found* arm = arm_of(a);
            if (arm == nullptr) continue;
            const Vec3 force = axes_.transpose() * last_[a].force_n;
            if (!first) put(",");
            first = false;
            put(R"({"device_id":")");
            put(arm->id.view());
            put(R"(","commands":{"set_cursor_force":{"values":{"x":)");
            put_number(force.x());
            put(R"(,"y":)");
            put_number(force.y());
            put(R"(,"z":)");
            put_number(force.z());
            put("}}}}");
        }
        put("]}");
        if (!first) socket_.send_text({text.data(), static_cast<size_t>(at - text.data())});
    }

    std::vector<sim::Hand> hands_;
    std::array<Id, kMaxArms> wanted_;
    Mat3 axes_;
    double max_force_n_;
    WebSocket socket_;
    uint32_t greeted_ = 0;
    std::array<Found, kMaxFound> arms_, grips_;
    size_t arm_count_ = 0, grip_count_ = 0;
    std::array<ArmForce, kMaxArms> last_;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_haply(const DeviceConfig& config) {
    const std::string right = config.station.text("haply.right");
    const std::string left = config.station.text("haply.left");
    if (!right.empty() && right == left)
        throw DeviceError("haply: haply.right and haply.left are both \"" + right +
                          "\"; give each arm its own id");
    const bool one_left = config.station.text("arm.one_hand") == "left";
    std::vector<sim::Hand> hands{left.empty() && one_left ? sim::Hand::kLeft : sim::Hand::kRight};
    std::vector<std::string> ids{right};
    if (!left.empty()) {
        hands.push_back(sim::Hand::kLeft);
        ids.push_back(left == "auto" ? "" : left);
    }
    return std::make_unique<HaplyDevice>(config, hands, ids);
}

}  // namespace placode::haptics
