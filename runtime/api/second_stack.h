/*
 * Functions of the host that robots do not have: a second stack, and findings in the report of the
 * run.  The part of an image that the kit adds calls them (kit/controller); sources of objects do
 * not know them.
 *
 * A stack belongs to one object and is used in its handlers only.
 */
#ifndef RUNTIME_API_SECOND_STACK_H_INCLUDED
#define RUNTIME_API_SECOND_STACK_H_INCLUDED

#ifdef __cplusplus
extern "C" {
#endif

struct OpenrSecondStack;

struct OpenrSecondStack* openr_second_stack_new(void);
void openr_second_stack_delete(struct OpenrSecondStack* stack);

/* Empties the stack and calls body(argument) on it; returns when body has ended or left. */
void openr_second_stack_run(struct OpenrSecondStack* stack, void (*body)(void*), void* argument);

/* Goes back to the handler; called by body.  Returns when body is continued. */
void openr_second_stack_leave(struct OpenrSecondStack* stack);

/* Continues body where it left; returns when body has ended or left.  REQUIRES: body has left. */
void openr_second_stack_continue(struct OpenrSecondStack* stack);

/* Adds a warning about the running object. */
void openr_finding(const char* text);

/* Adds the same warning with "did you mean" if one of the `count` known names is near to `name`. */
void openr_finding_of_name(const char* text, const char* name, const char* const* known, int count);

#ifdef __cplusplus
}
#endif

#endif /* RUNTIME_API_SECOND_STACK_H_INCLUDED */
