// strandline plan with --out-dir: several drawings, in threads of this process.
#include <fmt/format.h>

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <future>
#include <mutex>
#include <new>
#include <optional>

#include "batch.hpp"
#include "console.hpp"
#include "plan/pipeline/pipeline.hpp"
#include "result/check/check.hpp"
#include "result/formats/formats.hpp"
#include "summary.hpp"

namespace strandline::cli {
namespace {

namespace fs = std::filesystem;
using State = BatchItem::State;

/// What all threads look at. `mutex` guards record, items' states, `finished` and what is printed.
struct Batch {
    const Asked& asked;
    const BatchArguments& arguments;
    const Common& common;
    const Progress progress;
    const std::string asked_digest;
    std::vector<BatchItem> items;
    BatchRecord record;
    std::mutex mutex;
    std::atomic<std::size_t> next = 0;
    std::size_t finished = 0;
};

std::string file_name(const std::string& path) { return fs::path(path).filename().string(); }

/// One drawing's way, with what is to be said of it.
struct Job {
    BatchItem item;
    BatchEntry entry;
    std::string remarks;  ///< lines
};

Outcome<void> make(Job& job, const std::string& bytes, const Batch& batch) {
    const std::string title = file_name(job.item.input);
    const auto refused = [&](const Error& error) {
        return tl::unexpected(in_file(error, title, job.item.input));
    };
    const auto document = read_source({bytes, job.item.input}, batch.asked.wishes.options);
    if (!document) return refused(document.error());
    const auto made = planned(*document, title, batch.asked, batch.progress);
    if (batch.progress.stopped()) {  // what it could not do then, it may do when it is called again
        job.item.state = State::stopped;
        return {};
    }
    if (!made) return refused(made.error());
    const std::string text = formats::write_plan(*made);
    if (const auto written = write_output(job.item.output, text); !written) return written;
    const check::Report report = check::prove(*made);
    const Figures& f = made->figures;
    job.item.figures = {f.elements,
                        f.drawn,
                        f.time,
                        static_cast<int>(made->warnings.size() + made->idle_edits.size()),
                        static_cast<int>(report.faults.size()),
                        shortcomings(*made, report)};
    job.item.state = State::planned;
    job.entry.plan = digest_of(text);
    for (const Warning& warning : made->warnings) job.remarks += "warning: " + sentence(warning) + '\n';
    for (const std::string& idle : made->idle_edits) job.remarks += "warning: " + idle + '\n';
    job.remarks += findings(report, batch.common.verbose);
    return {};
}

/// Whether the plan in place is the one that would be made; `known`: what was written there last.
bool up_to_date(const Job& job, const std::optional<BatchEntry>& known) {
    if (!known || known->made_from != job.entry.made_from) return false;
    const auto there = read_input(job.item.output);
    return there && digest_of(*there) == known->plan;
}

std::optional<BatchEntry> entry_of(Batch& batch, const std::string& name) {
    const std::lock_guard lock(batch.mutex);
    const auto found = batch.record.find(name);
    return found == batch.record.end() ? std::nullopt : std::optional(found->second);
}

Outcome<void> done_with(Job& job, Batch& batch) {
    const auto bytes = read_input(job.item.input);
    if (!bytes) return tl::unexpected(bytes.error());
    // The title stands in the plan.
    job.entry.made_from =
        digest_of(batch.asked_digest + '\n' + file_name(job.item.input) + '\n' + digest_of(*bytes));
    const auto known = entry_of(batch, file_name(job.item.output));
    if (!batch.arguments.force && up_to_date(job, known)) {
        job.item.state = State::up_to_date;
        job.item.figures = known->figures;
        return {};
    }
    return make(job, *bytes, batch);
}

void show_count(const Batch& batch) {
    if (batch.common.quiet || batch.finished == batch.items.size()) return;
    show_bar(fmt::format("{} of {}", batch.finished, batch.items.size()),
             static_cast<double>(batch.finished) / static_cast<double>(batch.items.size()));
}

void tell(const Job& job, const Batch& batch) {
    show_bar("", 1);
    const BatchItem& item = job.item;
    if (item.state == State::failed) complain(item.error, bad_input);
    if (batch.common.quiet) return;
    fmt::print(stderr, "{}/{} {}: {}\n", batch.finished, batch.items.size(), item.input, outcome_text(item));
    std::string_view left = job.remarks;
    while (!left.empty()) {
        const std::size_t end = left.find('\n');
        fmt::print(stderr, "  {}\n", left.substr(0, end));
        left.remove_prefix(end + 1);
    }
    show_count(batch);
}

/// Takes the next drawing until there is none, or the user wants no more.
void work(Batch& batch) {
    for (;;) {
        const std::size_t k = batch.next++;
        if (k >= batch.items.size() || batch.progress.stopped()) return;
        Job job{batch.items[k], {}, {}};
        Outcome<void> fine;
        try {
            fine = done_with(job, batch);
        } catch (const std::bad_alloc&) {
            fine = fail(job.item.input, "not enough memory for this input",
                        "make it simpler, or plan fewer at once (-j)");
        } catch (const std::exception& error) {  // not foreseen: the other drawings shall not suffer
            fine = fail(job.item.input, error.what(), "report this with the drawing");
        }
        const std::lock_guard lock(batch.mutex);
        if (!fine) {
            job.item.state = State::failed;
            job.item.error = fine.error();
        }
        ++batch.finished;
        batch.items[k] = job.item;
        tell(job, batch);
        if (job.item.state != State::planned) continue;
        job.entry.figures = job.item.figures;
        batch.record[file_name(job.item.output)] = job.entry;
        const auto kept = write_batch_record(batch.arguments.folder, batch.record);
        if (!kept) warn({{kept.error().place, kept.error().reason + ": will be planned again"}}, false);
    }
}

/// Error: a call that asks for what a batch cannot do.
Outcome<void> fit_for_batch(const BatchArguments& batch, const PlanArguments& each) {
    if (batch.folder.empty())
        return fail("plan", "several drawings need a folder for their plans", "name it with --out-dir");
    if (batch.inputs.empty()) return fail("plan", "the drawings are missing", "name files");
    const std::pair<bool, const char*> others[] = {{each.output != "-", "-o"},
                                                   {!each.lettering.text.empty(), "--text"},
                                                   {!each.split.empty(), "--split"},
                                                   {each.open, "--open"}};
    for (const auto& [given, name] : others)
        if (given)
            return fail(name, "is for one drawing", "leave out " + std::string(name) + " or --out-dir");
    return {};
}

Outcome<void> folder_ready(const std::string& folder) {
    std::error_code made, looked;
    fs::create_directories(folder, made);
    if (fs::is_directory(folder, looked)) return {};
    const std::error_code why = made ? made : looked;
    return fail("--out-dir " + folder,
                "is no folder and cannot be made one" + (why ? ": " + why.message() : ""),
                "choose another name");
}

}  // namespace

int plan_all(const BatchArguments& arguments, const PlanArguments& each, const Common& common) {
    if (const auto fits = fit_for_batch(arguments, each); !fits) return complain(fits.error(), bad_call);
    const auto asked = asked_of(each);
    if (!asked) return complain(asked.error(), bad_call);
    const auto& tour = asked->wishes.options.tour;
    if (arguments.jobs > 1 && tour.threads > 1 && tour.time_limit > 0)
        return complain(
            {"tour.time_limit", "cannot be kept apart for plans whose searches have several threads",
             "set tour.threads=1, or -j 1"},
            bad_call);
    auto items = batch_items(arguments.inputs, arguments.folder);
    if (!items) return complain(items.error(), bad_call);
    if (const auto ready = folder_ready(arguments.folder); !ready) return complain(ready.error(), bad_call);

    Batch batch{*asked,
                arguments,
                common,
                console_progress(true),
                digest_of(*asked),
                std::move(*items),
                read_batch_record(arguments.folder),
                {},
                {},
                0};
    show_count(batch);
    std::vector<std::future<void>> threads;
    for (int k = 0; k < arguments.jobs; ++k)
        threads.push_back(std::async(std::launch::async, [&batch] { work(batch); }));
    for (auto& thread : threads) thread.get();

    if (common.json)
        fmt::print("{}", batch_json(batch.items));
    else if (!common.quiet)
        fmt::print(stderr, "{}", batch_table(batch.items));
    bool failed = false, left = false, short_of = false;
    for (const BatchItem& item : batch.items) {
        failed = failed || item.state == State::failed;
        left = left || item.state == State::stopped || item.state == State::waiting;
        if (each.strict && !item.figures.short_of.empty()) {
            fmt::print(stderr, "{}:\n{}", item.input, item.figures.short_of);
            short_of = true;
        }
    }
    return left ? stopped_by_user : failed ? bad_input : short_of ? falls_short : done;
}

}  // namespace strandline::cli
