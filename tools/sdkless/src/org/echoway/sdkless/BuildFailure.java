package org.echoway.sdkless;

/** The build cannot go on; the message says why and what to do, and is all that the user sees. */
final class BuildFailure extends RuntimeException {
    BuildFailure(String message) {
        super(message);
    }
}
