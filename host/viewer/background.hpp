#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <future>
#include <string>

namespace gabor::viewer {

/// Runs one task at a time on its own thread. Declare it after the members that the task writes: its
/// destructor cancels the task and waits for it.
class BackgroundTask {
  public:
    BackgroundTask() = default;
    ~BackgroundTask() { cancel(); }
    BackgroundTask(const BackgroundTask&) = delete;
    BackgroundTask& operator=(const BackgroundTask&) = delete;

    /// Waits for the previous task, then starts this one.
    void start(std::function<void()> work) {
        thread_ = {};
        error_.clear();
        cancelling_ = cancelled_ = false;
        progress_ = 0;
        thread_ = std::async(std::launch::async, [this, work = std::move(work)] {
            try {
                work();
            } catch (const Cancelled&) {
                cancelled_ = true;
            } catch (const std::exception& error) {
                error_ = error.what();
            }
        });
    }
    /// Requests cancellation: the next `advance` throws.
    void cancel() { cancelling_ = true; }
    /// To be called by the task: reports progress from 0 to 1. Throws once the task has been cancelled.
    void advance(double progress) {
        if (cancelling_)
            throw Cancelled();
        progress_ = progress;
    }

    bool running() const {
        return thread_.valid() && thread_.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
    }
    double progress() const { return progress_; }
    /// How the task ended; valid once it no longer runs.
    bool was_cancelled() const { return cancelled_; }
    const std::string& error() const { return error_; } ///< empty if it did not fail

  private:
    struct Cancelled {};

    std::atomic<bool> cancelling_ = false;
    std::atomic<double> progress_ = 0;
    bool cancelled_ = false; ///< the thread writes this and `error_`
    std::string error_;
    std::future<void> thread_;
};

} // namespace gabor::viewer
