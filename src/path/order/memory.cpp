#include "path/order/memory.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace strandline::order {
namespace {

void append_pivot(std::vector<Leg>& legs, Pose at, double turn) {
    if (turn == 0) return;
    legs.push_back({Motion::pivot, -1, {{0, at, 0}, {0, {at.at, at.heading + turn}, 0}}, {}});
}

std::array<double, 8> key_of(const CurvatureState& a, const CurvatureState& b) {
    return {a.pose.at.x, a.pose.at.y, a.pose.heading, a.curvature,
            b.pose.at.x, b.pose.at.y, b.pose.heading, b.curvature};
}

bool same_paths(const std::vector<std::vector<Curve>>& paths, const std::vector<Planned>& chain) {
    return std::ranges::equal(paths, chain, {}, {}, &Planned::rake_path);
}

}  // namespace

Drives::Answer Drives::driven(const std::vector<Planned>& chain, const std::vector<Stroke>& strokes,
                              const Robot& robot, const drive::Options& options) {
    const int first = chain.front().stroke;
    const Pose start = chain.front().rake_path.front().start, end = end_pose(chain.back().rake_path.back());
    const Stroke& stroke = strokes[static_cast<std::size_t>(first)];
    One& one = by_ends_[{start.at.x, start.at.y, start.heading, end.at.x, end.at.y, end.heading,
                         static_cast<double>(chain.size())}];
    if (!one.drive || one.fill != stroke.fill || one.pins != stroke.pins ||
        !same_paths(one.rake_paths, chain)) {
        one.rake_paths.clear();
        for (const Planned& link : chain) one.rake_paths.push_back(link.rake_path);
        one.fill = stroke.fill;
        one.pins = stroke.pins;
        auto drive = std::make_shared<drive::Drive>(drive_chain(chain, strokes, robot, options));
        for (Leg& leg : drive->legs)
            if (leg.stroke >= 0) leg.stroke -= first;
        one.drive = std::move(drive);
        one.led.reset();
    }
    one.used = true;
    return {one.drive, one.led};
}

void Drives::begin() {
    for (auto& [key, one] : by_ends_) one.used = false;
}
void Drives::end() {
    std::erase_if(by_ends_, [](const auto& entry) { return !entry.second.used; });
}

const Driven* Joints::find(const CurvatureState& from, const CurvatureState& to) {
    const auto found = by_states_.find(key_of(from, to));
    if (found == by_states_.end()) return nullptr;
    found->second.used = true;
    return &found->second.driven;
}
void Joints::keep(const CurvatureState& from, const CurvatureState& to, const Driven& driven) {
    by_states_[key_of(from, to)] = {driven};
}
std::shared_ptr<const std::vector<Leg>> Joints::legs(const CurvatureState& from, const CurvatureState& to,
                                                     const connect::Connection& joint, double step) {
    Driving& kept = driving_[key_of(from, to)];
    kept.used = true;
    if (kept.legs && kept.turn_before == joint.turn_before && kept.turn_after == joint.turn_after &&
        kept.step == step && kept.curve == joint.curve)
        return kept.legs;
    std::vector<Leg> legs;
    append_pivot(legs, from.pose, joint.turn_before);
    if (!joint.curve.pieces.empty())
        legs.push_back({Motion::connect, -1, states_along(joint.curve, step), joint.curve});
    append_pivot(legs, end_pose(joint.curve), joint.turn_after);
    kept = {joint.turn_before, joint.turn_after, step, joint.curve,
            std::make_shared<const std::vector<Leg>>(std::move(legs))};
    return kept.legs;
}
void Joints::begin() {
    for (auto& [key, one] : by_states_) one.used = false;
    for (auto& [key, one] : driving_) one.used = false;
}
void Joints::end() {
    std::erase_if(by_states_, [](const auto& entry) { return !entry.second.used; });
    std::erase_if(driving_, [](const auto& entry) { return !entry.second.used; });
}

std::vector<int> numbers_of(const Job& job) {
    std::unordered_map<std::string, int> met;
    std::vector<int> numbers;
    for (const Group& group : job.groups) numbers.push_back(met[group.name]++);
    return numbers;
}

void Memory::Kept::begin() {
    drives.begin();
    joints.begin();
}

void Memory::Kept::remember(const Job& job, const std::vector<Going>& goings) {
    drives.end();
    joints.end();
    const std::vector<int> numbers = numbers_of(job);
    row.clear();
    for (const Going& going : goings) {
        const auto group = static_cast<std::size_t>(going.step.element);
        row.push_back({job.groups[group].name, numbers[group], going});
    }
    field = job.field;
    keep_out = job.keep_out;
}

Memory::Memory() : kept_(std::make_unique<Kept>()) {}
Memory::~Memory() = default;
Memory::Memory(Memory&&) noexcept = default;
Memory& Memory::operator=(Memory&&) noexcept = default;

}  // namespace strandline::order
