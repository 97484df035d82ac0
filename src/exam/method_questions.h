#pragma once

#include "exam/exam_runs.h"
#include "radiosity/solve.h"

#include <string>
#include <vector>

namespace multipath {

/// The methods with their names.
struct NamedMethod
{
    const char* name;
    Method method;
};

inline const std::vector<NamedMethod> exam_methods = {{"local", Method::local},
                                                      {"global", Method::global},
                                                      {"first-shot", Method::first_shot},
                                                      {"extended", Method::extended},
                                                      {"reuse", Method::reuse}};

/// The independent runs of one method with one sequence, under the broken law if there is one. `lines` per run.
std::vector<Solution> solved_runs(const Scene& scene, const Preparation& preparation, Method method,
                                  const std::string& sequence, const ExamSettings& settings);

/// What solve needs to know of the scene beforehand.
Preparation preparation_for(const Scene& scene, Method method);

/// The mean power that the runs left unshot [W]. Zero for the local method, of which nothing is missing: what Russian
/// roulette creates and destroys is zero in expectation.
double mean_unshot(const std::vector<Solution>& runs, Method method);

/// Does emitted = absorbed + unshot + escaped + behind hold in all runs?
ExamRow balance_row(const std::string& topic, const std::string& method, const std::vector<Solution>& runs);

/// Every known scene, solved by every method with every sequence.
std::vector<ExamTask> method_tasks(const ExamSettings& settings);

} // namespace multipath
