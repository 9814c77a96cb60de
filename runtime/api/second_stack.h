/*
 * Functions that only the host has: a second stack, on which a controller's endless loop runs, and
 * findings, which appear in the report of the run.  They are called by the code that the kit adds
 * to the image of a controller (kit/controller), and not by the sources of objects, which must also
 * compile for the robot.
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

/*
 * Empties the stack and calls body(argument) on it.  Returns when body has ended or has called
 * openr_second_stack_leave().
 */
void openr_second_stack_run(struct OpenrSecondStack* stack, void (*body)(void*), void* argument);

/*
 * Called by body: goes back to the handler.  Returns when a handler calls
 * openr_second_stack_continue().
 */
void openr_second_stack_leave(struct OpenrSecondStack* stack);

/*
 * Continues body after its call of openr_second_stack_leave().  Returns when body has ended or has
 * called that function again.
 */
void openr_second_stack_continue(struct OpenrSecondStack* stack);

/* Adds the warning `text` about the running object to the findings. */
void openr_finding(const char* text);

/*
 * Adds the warning `text` as openr_finding() does, and "did you mean" if one of the `count` known
 * names is near to `name`.
 */
void openr_finding_of_name(const char* text, const char* name, const char* const* known, int count);

#ifdef __cplusplus
}
#endif

#endif /* RUNTIME_API_SECOND_STACK_H_INCLUDED */
