# Where jni.h is on a host: beside the compiler that is on the path, wherever the distribution put that JDK. Sets
# ECHOWAY_JNI_INCLUDES, empty where there is none. On Android the NDK has jni.h and nothing need be found.
find_program(ECHOWAY_JAVAC javac HINTS ENV JAVA_HOME PATH_SUFFIXES bin)
get_filename_component(javac_real "${ECHOWAY_JAVAC}" REALPATH)
get_filename_component(jdk_home "${javac_real}/../.." ABSOLUTE)
find_path(ECHOWAY_JNI_INCLUDE jni.h HINTS ENV JAVA_HOME "${jdk_home}" PATH_SUFFIXES include)
find_path(ECHOWAY_JNI_MD_INCLUDE jni_md.h HINTS "${ECHOWAY_JNI_INCLUDE}" PATH_SUFFIXES linux darwin win32)
set(ECHOWAY_JNI_INCLUDES "")
if(ECHOWAY_JNI_INCLUDE AND ECHOWAY_JNI_MD_INCLUDE)
  set(ECHOWAY_JNI_INCLUDES ${ECHOWAY_JNI_INCLUDE} ${ECHOWAY_JNI_MD_INCLUDE})
endif()
