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
#include "haptics/haply_message.h"
#include "haptics/real_time.h"
#include "haptics/web_socket.h"

namespace placode::haptics {

namespace {

constexpr int64_t kSilenceNs = 100'000'000;  // older states count as lost
constexpr int64_t kOpenNs = 1'500'000'000;   // patience when the program starts,
constexpr int64_t kNobodyNs = 300'000'000;   // and while nobody even takes the call
constexpr std::string_view kHello = R"({"session":{"force_render_full_state":{}}})";

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
        socket_.hand_over();  // else the last forces would not be taken
        send_forces();
        socket_.close();
    }

 protected:
    void sense(int64_t t_ns, std::span<ArmSample> samples) noexcept override {
        pump(t_ns);
        for (size_t a = 0; a < samples.size(); ++a) {
            const HaplyFound* arm = arm_of(a);
            if (arm == nullptr || t_ns - arm->seen_ns > kSilenceNs ||
                socket_.state() != WebSocket::State::kOpen)
                continue;  // lost
            ArmSample& sample = samples[a];
            sample.status =
                arm->calibrated && arm->ready ? DeviceStatus::kReady : DeviceStatus::kNotCalibrated;
            sample.held = true;  // the arm does not know; its force begins by a ramp
            sample.position_m = axes_ * arm->position;
            if (a < parts_.grip_count && t_ns - parts_.grips[a].seen_ns <= kSilenceNs) {
                const Quat& q = parts_.grips[a].orientation;
                sample.orientation = q;
                // Turn about the grip's own long axis.
                sample.roll_rad = 2 * std::atan2(q.z(), q.w());
                sample.buttons = parts_.grips[a].buttons;
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
            if (const HaplyFound* arm = arm_of(a)) info.serial = arm->id.view();
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
    [[nodiscard]] const HaplyFound* arm_of(size_t a) const noexcept {
        const bool left = hands_[a] == sim::Hand::kLeft && hands_.size() > 1;
        for (size_t i = 0; i < parts_.arm_count; ++i) {
            const HaplyFound& arm = parts_.arms[i];
            const bool side = hands_.size() == 1 || arm.left == left;
            if (wanted_[a].view().empty() ? side : arm.id.view() == wanted_[a].view()) return &arm;
        }
        return nullptr;
    }

    void wait_for_arms(const Station& station) {
        const int64_t until = monotonic_ns() + kOpenNs;
        bool all = false;
        const int64_t nobody = monotonic_ns() + kNobodyNs;
        // Where nobody listens the call is refused at once; who took it may be busy.
        const auto taken = [&] {
            return socket_.connections() > 0 || socket_.state() == WebSocket::State::kShaking;
        };
        while (!all && monotonic_ns() < (taken() ? until : nobody)) {
            pump(monotonic_ns());
            send_forces();
            all = true;
            for (size_t a = 0; a < hands_.size(); ++a) all = all && arm_of(a) != nullptr;
            sleep_until(monotonic_ns() + 1'000'000);
        }
        if (!all) throw DeviceError(absent(station));
        for (size_t a = 0; a < hands_.size(); ++a) {
            const HaplyFound& arm = *arm_of(a);
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
        for (size_t i = 0; i < parts_.arm_count; ++i)
            found += (i > 0 ? ", " : "") + std::string(parts_.arms[i].id.view()) +
                     (parts_.arms[i].left ? " (left)" : " (right)");
        return "haply: the Inverse service at " + place + " runs, but not every arm is there; it " +
               "shows " + (found.empty() ? "none" : found) +
               ". Plug in and switch on the Inverse3, or change haply.right and haply.left.";
    }

    void pump(int64_t t_ns) noexcept {
        socket_.step(t_ns);
        if (socket_.state() == WebSocket::State::kOpen && greeted_ != socket_.connections() &&
            socket_.send_text(kHello)) {
            greeted_ = socket_.connections();
            for (HaplyFound& arm : parts_.arms) arm.calibrated = arm.ready = false;
        }
        std::string_view text;
        while (socket_.next_message(text)) parts_.read(text, t_ns);
    }

    void send_forces() noexcept {
        if (parts_.arm_count == 0) {
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
            const HaplyFound* arm = arm_of(a);
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
    std::array<HaplyId, kMaxArms> wanted_;
    Mat3 axes_;
    double max_force_n_;
    WebSocket socket_;
    uint32_t greeted_ = 0;
    HaplyParts parts_;
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
