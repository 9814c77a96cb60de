/*
 * What the kit's own parts of an image may ask of the host and of no robot: a second stack, and to
 * say something in the report of the run.  Objects know nothing of it (kit/controller).
 *
 * A stack belongs to one object and is used in its methods only.
 */
#ifndef RUNTIME_API_SECOND_STACK_H_INCLUDED
#define RUNTIME_API_SECOND_STACK_H_INCLUDED

#ifdef __cplusplus
extern "C" {
#endif

struct OpenrSecondStack;

struct OpenrSecondStack* openr_second_stack_new(void);
void openr_second_stack_delete(struct OpenrSecondStack* stack);

/* Calls body(argument) there, on an empty stack; returns when it has ended or left. */
void openr_second_stack_run(struct OpenrSecondStack* stack, void (*body)(void*), void* argument);

/* Called by body; returns when it is continued. */
void openr_second_stack_leave(struct OpenrSecondStack* stack);

/* Goes on where body left; returns as openr_second_stack_run() does.  REQUIRES: body has left. */
void openr_second_stack_continue(struct OpenrSecondStack* stack);

/* A warning about the running object. */
void openr_finding(const char* text);

/* The same, and which of the `count` known names is near to `name`, if one is. */
void openr_finding_of_name(const char* text, const char* name, const char* const* known, int count);

#ifdef __cplusplus
}
#endif

#endif /* RUNTIME_API_SECOND_STACK_H_INCLUDED */
