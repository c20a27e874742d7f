package org.echoway.sdkless;
final class GradleCheck { GradleCheck(Workspace w){} void run(){} }
