#include "study/pieces.hpp"

#include <stdexcept>

namespace gabor::study {

namespace {

std::span<const double> take(std::span<const double>& numbers, std::size_t count) {
    if (numbers.size() < count)
        throw std::runtime_error("a piece of a row is not complete");
    const std::span<const double> taken = numbers.first(count);
    numbers = numbers.subspan(count);
    return taken;
}

void write(Numbers& numbers, const statistics::Moments& moments) {
    const statistics::Moments::State& state = moments.state();
    numbers.insert(numbers.end(), {static_cast<double>(state.count), state.mean, state.m2, state.m3, state.m4,
                                   state.minimum, state.maximum});
}

statistics::Moments take_moments(std::span<const double>& numbers) {
    const std::span<const double> n = take(numbers, 7);
    return statistics::Moments({static_cast<std::uint64_t>(n[0]), n[1], n[2], n[3], n[4], n[5], n[6]});
}

std::span<const double> take_list(std::span<const double>& numbers) {
    return take(numbers, static_cast<std::size_t>(take(numbers, 1).front()));
}

} // namespace

void write(Numbers& numbers, const ValueStatistics& values) {
    write(numbers, values.moments);
    const statistics::Counts& counts = values.gaussianity.counts();
    numbers.insert(numbers.end(), counts.begin(), counts.end());
}

void merge(ValueStatistics& values, std::span<const double>& numbers) {
    values.moments.merge(take_moments(numbers));
    const std::span<const double> counts = take(numbers, values.gaussianity.counts().size());
    values.gaussianity.merge(statistics::Gaussianity(1, {counts.begin(), counts.end()}));
}

void write(Numbers& numbers, const std::vector<double>& list) {
    numbers.push_back(static_cast<double>(list.size()));
    numbers.insert(numbers.end(), list.begin(), list.end());
}

void merge(std::vector<double>& list, std::span<const double>& numbers) {
    const std::span<const double> more = take_list(numbers);
    list.insert(list.end(), more.begin(), more.end());
}

void write(Numbers& numbers, const statistics::InstanceStationarity& windows) {
    write(numbers, windows.contrasts());
}

void merge(statistics::InstanceStationarity& windows, std::span<const double>& numbers) {
    windows.add_contrasts(take_list(numbers));
}

void write(Numbers& numbers, const PlaceStatistics& places) {
    numbers.push_back(static_cast<double>(places.cvm.size()));
    for (std::size_t i = 0; i < places.cvm.size(); ++i) {
        write(numbers, places.stationarity.places()[i]);
        const statistics::Estimate& cvm = places.cvm[i];
        numbers.insert(numbers.end(), {cvm.value, cvm.low, cvm.high});
    }
}

void merge(PlaceStatistics& places, std::span<const double>& numbers) {
    for (auto left = static_cast<std::size_t>(take(numbers, 1).front()); left > 0; --left) {
        places.stationarity.add(take_moments(numbers));
        const std::span<const double> cvm = take(numbers, 3);
        places.cvm.push_back({cvm[0], cvm[1], cvm[2]});
    }
}

} // namespace gabor::study
