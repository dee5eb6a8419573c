// Errors, progress, cancelling and texts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>

#include "handles.hpp"

namespace footfall::c {
namespace {

// Kept apart from the text, so that running out of memory has a message too.
thread_local std::string lastText;
thread_local const char* lastMessage = "";

footfall_status keep(footfall_status status, const char* function, const char* what) noexcept {
  try {
    lastText = std::string(function) + ": " + what;
    lastMessage = lastText.c_str();
  } catch (const std::bad_alloc&) {
    lastMessage = "memory ran out";
  }
  return status;
}

}  // namespace

footfall_status keepMessage(const char* function) noexcept {
  try {
    throw;
  } catch (const Cancelled& error) {
    return keep(FOOTFALL_CANCELLED, function, error.what());
  } catch (const InputError& error) {
    return keep(FOOTFALL_INPUT_ERROR, function, error.what());
  } catch (const RunError& error) {
    return keep(FOOTFALL_RUN_ERROR, function, error.what());
  } catch (const std::bad_alloc&) {
    return keep(FOOTFALL_RUN_ERROR, function, "memory ran out; close other programs or use a smaller environment");
  } catch (const std::exception& error) {
    return keep(FOOTFALL_INTERNAL, function, error.what());
  } catch (...) {
    return keep(FOOTFALL_INTERNAL, function, "an unknown error");
  }
}

char* copyOf(const std::string& text) {
  auto* const copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (copy == nullptr) throw std::bad_alloc();
  std::memcpy(copy, text.c_str(), text.size() + 1);
  return copy;
}

}  // namespace footfall::c

using namespace footfall;
using namespace footfall::c;

const char* footfall_message(void) { return lastMessage; }

const char* footfall_version(void) { return version(); }

void footfall_free_text(char* text) { std::free(text); }

footfall_status footfall_make_context(footfall_progress progress, void* user, footfall_context** context) {
  return guarded(__func__, [&] {
    given(context, "context");
    if (progress == nullptr) {
      *context = new footfall_context{};
      return;
    }
    *context = new footfall_context{RunContext([progress, user](const RunEvent& event) {
      using Kind = RunEvent::Kind;
      if (event.kind == Kind::StepStarted || event.kind == Kind::Progress || event.kind == Kind::StepFinished)
        progress(user, event.step, event.text.c_str(), event.fraction);
    })};
  });
}

void footfall_cancel(footfall_context* context) {
  if (context != nullptr) context->context.cancel();
}

void footfall_free_context(footfall_context* context) { delete context; }
