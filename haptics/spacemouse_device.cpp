// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// 3Dconnexion SpaceMouse through the socket of spacenavd (protocol 0: events of eight 32-bit
// numbers, nothing to ask for). Rate control in the picture; no force.
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "haptics/window_hands.h"

namespace placode::haptics {

namespace {

constexpr double kDeadZone = 15, kFull = 350;
constexpr double kRollRadS = 1.5;
// spacenavd repeats the last motion and may never send the zero: without an event the cap is
// taken to be at rest.
constexpr int64_t kSilenceNs = 100'000'000, kAskAgainNs = 1'000'000'000;
constexpr int32_t kMotion = 0, kPress = 1, kRelease = 2;

double deflection(int32_t axis) noexcept {
    const double size = std::abs(static_cast<double>(axis));
    if (size <= kDeadZone) return 0;
    return std::copysign(std::min(1.0, (size - kDeadZone) / (kFull - kDeadZone)), axis);
}

int connect_to(const std::string& path) noexcept {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) {
        errno = ENAMETOOLONG;
        return -1;
    }
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    const int file = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (file < 0) return -1;
    if (connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0)
        return file;
    const int why = errno;
    ::close(file);
    errno = why;
    return -1;
}

class SpaceMouseDevice final : public WindowHands {
 public:
    explicit SpaceMouseDevice(const DeviceConfig& config)
        : WindowHands(config, "SpaceMouse"), speed_(config.station.number("spacemouse.speed_m_s")) {
        std::vector<std::string> paths;
        if (const std::string named = config.station.text("spacemouse.socket"); !named.empty())
            paths = {named};
        else if (const char* variable = std::getenv("SPNAV_SOCKET"))
            paths = {variable};
        else
            paths = {"/run/spnav.sock", "/var/run/spnav.sock"};
        std::string problems;
        for (const std::string& path : paths) {
            file_ = connect_to(path);
            path_ = path;
            if (file_ >= 0) return;
            problems += (problems.empty() ? "" : "; ") + path + ": " + std::strerror(errno);
        }
        throw DeviceError("spacemouse: spacenavd does not answer (" + problems +
                          "). Install and start it: sudo apt install spacenavd; sudo systemctl "
                          "enable --now spacenavd; or name its socket by spacemouse.socket in the "
                          "station file.");
    }
    ~SpaceMouseDevice() override { stop(); }
    void stop() noexcept override {
        if (file_ >= 0) ::close(file_);
        file_ = -1;
    }

 protected:
    void before_read(int64_t t_ns) noexcept override {
        if (file_ < 0 && t_ns >= retry_ns_) {
            file_ = connect_to(path_);
            retry_ns_ = t_ns + kAskAgainNs;
        }
        drain(t_ns);
        if (t_ns - moved_ns_ > kSilenceNs) axes_.fill(0);
    }

    void move(const sim::WindowInput&, const sim::WindowInput&, double dt_s, WindowHand& active,
              WindowHand*) noexcept override {
        // spacenavd: x right, y up, z away from the user; D has z towards the operator.
        const Vec3 direction(deflection(axes_[0]), deflection(axes_[1]), -deflection(axes_[2]));
        ease(active, speed_ * direction, dt_s);
        active.roll_rad += kRollRadS * dt_s * deflection(axes_[4]);
    }
    [[nodiscard]] uint8_t buttons(const sim::WindowInput&) const noexcept override {
        return static_cast<uint8_t>(((held_ & 1u) != 0 ? sim::kPedalCut : 0) |
                                    ((held_ & 2u) != 0 ? sim::kPedalCoag : 0));
    }
    [[nodiscard]] bool present(const sim::WindowInput&) const noexcept override {
        return file_ >= 0;
    }

 private:
    // Takes everything that waits: queued events would be motion to come.
    void drain(int64_t t_ns) noexcept {
        while (file_ >= 0) {
            const ssize_t got = ::recv(file_, buffer_.data() + size_, buffer_.size() - size_, 0);
            if (got < 0 && errno == EINTR) continue;
            if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return;
            if (got <= 0) {
                stop();
                axes_.fill(0);
                held_ = 0;
                size_ = 0;
                retry_ns_ = t_ns + kAskAgainNs;
                return;
            }
            size_ += static_cast<size_t>(got);
            constexpr size_t length = 8 * sizeof(int32_t);
            size_t at = 0;
            for (; at + length <= size_; at += length) {
                std::array<int32_t, 8> event;
                std::memcpy(event.data(), buffer_.data() + at, length);
                take(event, t_ns);
            }
            std::memmove(buffer_.data(), buffer_.data() + at, size_ - at);
            size_ -= at;
        }
    }

    void take(const std::array<int32_t, 8>& event, int64_t t_ns) noexcept {
        if (event[0] == kMotion) {
            std::copy_n(event.begin() + 1, 6, axes_.begin());
            moved_ns_ = t_ns;
        } else if ((event[0] == kPress || event[0] == kRelease) && event[1] >= 0 && event[1] < 32) {
            const uint32_t bit = 1u << event[1];
            held_ = event[0] == kPress ? held_ | bit : held_ & ~bit;
        }
    }

    double speed_;
    std::string path_;
    int file_ = -1;
    std::array<char, 1024> buffer_{};
    size_t size_ = 0;
    std::array<int32_t, 6> axes_{};
    uint32_t held_ = 0;
    int64_t moved_ns_ = 0, retry_ns_ = 0;
};

}  // namespace

std::unique_ptr<DeviceGroup> open_spacemouse(const DeviceConfig& config) {
    return std::make_unique<SpaceMouseDevice>(config);
}

}  // namespace placode::haptics
