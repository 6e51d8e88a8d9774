# Installs the packages of the lock file, with those for tests, into DIRECTORY, unless it holds
# exactly these already. Variables: SOURCE, DIRECTORY, NPM.
file(SHA256 "${SOURCE}/package-lock.json" lock)
set(stamp "${DIRECTORY}/installed.sha256")
if(EXISTS "${stamp}")
    file(READ "${stamp}" installed)
    if(installed STREQUAL lock)
        return()
    endif()
endif()
file(COPY "${SOURCE}/package.json" "${SOURCE}/package-lock.json" "${SOURCE}/.npmrc"
     DESTINATION "${DIRECTORY}")
execute_process(COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund
                WORKING_DIRECTORY "${DIRECTORY}" RESULT_VARIABLE status)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "npm ci failed (${status}) in ${DIRECTORY}")
endif()
file(WRITE "${stamp}" "${lock}")
